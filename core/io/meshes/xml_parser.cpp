#include "core/io/meshes/xml_parser.h"

#include <expat.h>

#include <exception>
#include <new>

#include "core/io/refuse_input.h"
#include "core/io/shown.h"

namespace handlebody {
namespace {

constexpr int kDeepestElement = 64;
//! expat keeps a tag until it has all of it, and looks at it anew with every piece.
constexpr XML_Index kLongestTag = 1 << 20;

}  // namespace

const char* XmlAttributes::find(std::string_view name) const {
  for (const char* const* at = list_; *at; at += 2)
    if (name == *at) return at[1];
  return nullptr;
}

struct XmlParser::State {
  XmlHandler& handler;
  std::string path, format, part;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> parser{nullptr, &XML_ParserFree};
  std::exception_ptr thrown{};
  int depth = 0;
  XML_Index taken = 0;

  [[noreturn]] void refuse(const Finding& what) const {
    const auto line = static_cast<unsigned long long>(XML_GetCurrentLineNumber(parser.get()));
    refuseInput(path, {FindingKind::damagedBecause,
                       {{"format", format}},
                       Finding(FindingKind::xmlAt, {{"line", line}, {"part", shown(part)}}, what)});
  }

  //! Nothing may be thrown through expat, which is C.
  template <typename Call>
  void guarded(Call&& call) noexcept {
    if (thrown) return;  // a few calls still come after it was stopped
    try {
      call();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser.get(), XML_FALSE);
    }
  }

  static State& of(void* user) { return *static_cast<State*>(user); }

  static void XMLCALL onStart(void* user, const XML_Char* name, const XML_Char** attributes) {
    State& s = of(user);
    s.guarded([&] {
      if (++s.depth > kDeepestElement) s.refuse(FindingKind::xmlNested);
      s.handler.start(name, XmlAttributes(attributes));
    });
  }
  static void XMLCALL onEnd(void* user, const XML_Char*) {
    State& s = of(user);
    s.guarded([&] {
      --s.depth;
      s.handler.end();
    });
  }
  static void XMLCALL onText(void* user, const XML_Char* text, int n) {
    State& s = of(user);
    s.guarded([&] { s.handler.text({text, static_cast<std::size_t>(n)}); });
  }
  static void XMLCALL onPrefix(void* user, const XML_Char* prefix, const XML_Char* space) {
    State& s = of(user);
    s.guarded([&] { s.handler.declare(prefix ? prefix : "", space ? space : ""); });
  }
  static void XMLCALL onType(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    State& s = of(user);
    s.guarded([&] { s.refuse(FindingKind::xmlWithType); });
  }

  void parse(std::string_view bytes, bool isLast) {
    const XML_Status status =
        XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), isLast ? 1 : 0);
    if (thrown) std::rethrow_exception(thrown);
    if (status != XML_STATUS_OK) {
      const XML_Error error = XML_GetErrorCode(parser.get());
      if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
      refuse({FindingKind::xmlFault, {{"reason", shown(XML_ErrorString(error))}}});
    }
    taken += static_cast<XML_Index>(bytes.size());
    if (!isLast && taken - XML_GetCurrentByteIndex(parser.get()) > kLongestTag)
      refuse(FindingKind::xmlTagTooLong);
  }
};

XmlParser::XmlParser(XmlHandler& handler, std::string path, std::string format, std::string part)
    : state_(new State{handler, std::move(path), std::move(format), std::move(part)}) {
  State& s = *state_;
  s.parser.reset(XML_ParserCreateNS(nullptr, ' '));
  if (!s.parser) throw std::bad_alloc();
  XML_SetUserData(s.parser.get(), &s);
  XML_SetElementHandler(s.parser.get(), &State::onStart, &State::onEnd);
  XML_SetCharacterDataHandler(s.parser.get(), &State::onText);
  XML_SetStartNamespaceDeclHandler(s.parser.get(), &State::onPrefix);
  XML_SetStartDoctypeDeclHandler(s.parser.get(), &State::onType);
}

XmlParser::~XmlParser() = default;

void XmlParser::take(std::string_view bytes) {
  constexpr std::size_t kPiece = 1 << 20;  // expat counts in int
  for (std::size_t at = 0; at < bytes.size(); at += kPiece) state_->parse(bytes.substr(at, kPiece), false);
}

void XmlParser::finish() { state_->parse({}, true); }

}  // namespace handlebody
