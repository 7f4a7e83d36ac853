#include "app/cli/tunnel_text.h"

#include <cstdarg>
#include <cstdio>
#include <numeric>

namespace handlebody::cli {

namespace {

__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

int genusOf(const Certificate& c) { return std::accumulate(c.genus.begin(), c.genus.end(), 0); }

}  // namespace

std::string piecesText(const std::vector<Piece>& pieces) {
  std::string out;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& p = pieces[i];
    out += formatted("component %zu: %s of %.4g ml, %.4g x %.4g x %.4g mm at %.4g,%.4g,%.4g, genus %d", i,
                     p.isCavity ? "cavity" : "body", p.volume / 1000, p.size.x(), p.size.y(), p.size.z(),
                     p.centre.x(), p.centre.y(), p.centre.z(), p.genus);
    if (p.within >= 0) out += formatted(", in component %d", p.within);
    out += '\n';
  }
  return out;
}

std::string tunnelsText(const TunnelList& list) {
  std::string out;
  for (const Tunnel& t : list.tunnels) {
    out += formatted("tunnel at %.4g,%.4g,%.4g: %.4g mm round the tunnel, %.4g mm around its handle",
                     t.position.x(), t.position.y(), t.position.z(), t.tunnel.length, t.handle.length);
    if (!t.tunnelBounds) out += ", which is knotted";
    if (!t.handleBounds) out += "; the tunnel is knotted";
    out += '\n';
  }
  if (list.unlisted > 0) out += formatted("tunnels without a list: %d\n", list.unlisted);
  return out;
}

std::string editText(const Event& e) {
  std::string out = formatted("%s at %.4g,%.4g,%.4g", eventKindName(e.kind), e.location.x(), e.location.y(),
                              e.location.z());
  const EditMeasures measures = e.edit.value_or(EditMeasures{});
  if (measures.loop > 0) out += formatted(", loop of %.4g mm", measures.loop);
  return out + formatted(": %.6g ml, was %.6g ml", measures.volumeAfter / 1000, measures.volumeBefore / 1000);
}

std::string changeText(const Certificate& before, const Certificate& after) {
  return formatted("volume %.6g ml, was %.6g ml; components %d, was %d; genus %d, was %d",
                   after.volume / 1000, before.volume / 1000, after.components, before.components,
                   genusOf(after), genusOf(before));
}

}  // namespace handlebody::cli
