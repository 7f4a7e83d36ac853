#include "core/io/refuse_input.h"

#include "core/told_error.h"

namespace handlebody {

void refuseInput(const std::string& path, const Finding& cause) {
  throw Told<InputError>(Finding(FindingKind::fileRefused, {{"file", path}}, cause));
}

void refuseInput(const std::string& path, const std::string& cause) {
  refuseInput(path, {FindingKind::other, {{"text", cause}}});
}

void refuseSurface(const std::string& path, const InputError& why) {
  throw Told<InputError>(Finding(FindingKind::noSurface, {{"file", path}}, saidBy(why)));
}

}  // namespace handlebody
