#include "core/io/refuse_input.h"

#include "core/told_error.h"

namespace handlebody {

void refuseInput(const std::string& path, const Finding& cause) {
  throw Told<InputError>(Finding(FindingKind::fileRefused, {{"file", path}}, cause));
}

void refuseInput(const std::string& path, const std::string& cause) {
  refuseInput(path, {FindingKind::other, {{"text", cause}}});
}

}  // namespace handlebody
