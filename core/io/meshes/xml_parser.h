#pragma once
// Internal: XML as it comes, through expat, which does not show here. Nothing of the document is kept.

#include <memory>
#include <string>
#include <string_view>

namespace handlebody {

//! Of an element. Names are "NAMESPACE name", or "name" where the attribute has no prefix.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char* const* list) : list_(list) {}
  //! Null if there is none of that name.
  const char* find(std::string_view name) const;

 private:
  const char* const* list_;  // name, value, …, null
};

//! Is told what the document holds, in its order. What it throws ends the parsing.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  //! A prefix of the element that starts next.
  virtual void declare(std::string_view /*prefix*/, std::string_view /*space*/) {}
  //! "NAMESPACE name".
  virtual void start(std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end() {}
  //! A piece of text; what belongs together may come in several.
  virtual void text(std::string_view /*piece*/) {}
};

//! Throws InputError for what is not well-formed or encoded otherwise than it says, and for what only hostile
//! documents have: a document type declaration (entities that multiply), deep nesting, a tag or comment of
//! more than a megabyte.
class XmlParser {
 public:
  //! `path`, `format` and `part`: the file, what it should be, and what of it is parsed, for sentences.
  XmlParser(XmlHandler& handler, std::string path, std::string format, std::string part);
  ~XmlParser();
  XmlParser(const XmlParser&) = delete;
  XmlParser& operator=(const XmlParser&) = delete;

  void take(std::string_view bytes);
  //! There is no more.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace handlebody
