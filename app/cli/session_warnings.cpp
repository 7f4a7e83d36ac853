#include "app/cli/session_warnings.h"

#include <cstdio>

#include "core/version.h"

namespace handlebody::cli {

std::vector<Finding> leaveOutUnseeded(std::vector<Session>& sessions) {
  std::vector<Finding> warnings;
  for (const Session& session : sessions)
    if (!isSeeded(session))
      warnings.push_back({FindingKind::leftOutUnseeded, {{"object", session.label.name}}});
  const std::string view = sessions[0].view;
  std::erase_if(sessions, [](const Session& session) { return !isSeeded(session); });
  sessions[0].view = view;
  return warnings;
}

std::vector<Finding> warningsOfVersion(const std::string& called, const std::string& version) {
  if (version == HANDLEBODY_VERSION) return {};
  return {{FindingKind::otherVersion,
           {{"session", called}, {"version", version}, {"here", std::string(HANDLEBODY_VERSION)}}}};
}

void tellWarnings(const std::vector<Finding>& warnings) {
  for (const Finding& d : warnings)
    std::fprintf(stderr, "handlebody-cli: warning: %s\n", sentence(d).c_str());
}

}  // namespace handlebody::cli
