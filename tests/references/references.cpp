#include "tests/references/references.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>

namespace handlebody::test {

namespace fs = std::filesystem;

namespace {

constexpr std::array kSourceEndings{".h", ".cpp", ".txx", ".cmake", ".txt", ".sh", ".json", ".in"};
// A word of these pages alone says nothing of the sources.
constexpr std::array kNotSources{"docs", "resources", "sample_volumes"};

std::string textOf(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

bool isSource(const std::string& path) {
  const bool apart = std::any_of(kNotSources.begin(), kNotSources.end(), [&](const char* folder) {
    return path.rfind(std::string(folder) + "/", 0) == 0 && !path.ends_with(".cpp") && !path.ends_with(".h");
  });
  return !apart && std::any_of(kSourceEndings.begin(), kSourceEndings.end(),
                               [&](const char* ending) { return path.ends_with(ending); });
}

//! Names of TEST_CASE, also where they are written as several literals, and of add_test.
std::set<std::string> testsOf(const std::string& text) {
  static const std::regex test(R"re((?:TEST_CASE\(|add_test\(NAME)\s*((?:"(?:[^"\\]|\\.)*"\s*)+))re");
  static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  std::set<std::string> names;
  for (std::sregex_iterator t(text.begin(), text.end(), test), end; t != end; ++t) {
    const std::string literals = (*t)[1];
    std::string name;
    for (std::sregex_iterator l(literals.begin(), literals.end(), literal); l != end; ++l) name += (*l)[1];
    names.insert(name);
  }
  return names;
}

void addWords(const std::string& text, std::set<std::string>& words) {
  static const std::regex word(R"(--[a-z][a-z-]*|[A-Za-z_]\w*)");
  for (std::sregex_iterator w(text.begin(), text.end(), word), end; w != end; ++w) words.insert(w->str());
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

bool hasWord(const std::string& line, const std::string& word) {
  return std::regex_search(line, std::regex("\\b" + word + "\\b"));
}

//! "core/mesh/mesh" for core/mesh/mesh.h and .cpp; other paths as they are.
std::string withoutEnding(const std::string& path) {
  for (const std::string ending : {".h", ".cpp"})
    if (path.ends_with(ending)) return path.substr(0, path.size() - ending.size());
  return path;
}

//! A line of a page, what was named on it so far, and what is wrong with it.
class Line {
 public:
  Line(const Project& project, std::string place, std::vector<std::string>& broken)
      : project_(project), place_(std::move(place)), broken_(broken) {}

  void check(const std::string& text) {
    static const std::regex span("`([^`]+)`");
    for (std::sregex_iterator s(text.begin(), text.end(), span), end; s != end; ++s) {
      const std::string between = s->prefix();
      if (between == ": ")
        list_ = before_;
      else if (between != ", ")
        list_.clear();
      before_ = (*s)[1];
      checkSpan(before_);
    }
    endPlace();
  }
  void checkLinks(const std::string& text, const fs::path& folder) {
    static const std::regex link(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
    for (std::sregex_iterator l(text.begin(), text.end(), link), end; l != end; ++l) {
      const std::string to = (*l)[1];
      if (to.find("://") != std::string::npos) continue;
      const std::string path = (folder / to).lexically_normal().generic_string();
      if (project_.paths.count(path) == 0) tell("there is no file " + path);
    }
  }

 private:
  void tell(const std::string& what) { broken_.push_back(place_ + ": " + what); }

  void checkSpan(const std::string& span) {
    static const std::regex path(R"([\w.-]+(/[\w.-]+)+/?)");
    static const std::regex quoted(R"re("([^"]+)")re");
    static const std::regex identifier(R"re((?:\w+(?:::|\.|->))*([A-Za-z_]\w*)(?:\(\))?)re");
    static const std::regex option("--[a-z][a-z-]*");
    static const std::regex place(R"(([\w.-]+(?:/[\w.-]+)+):(\d{1,6}))");
    std::smatch match;
    if (std::regex_match(span, match, place))
      checkPlace(match[1], std::stoul(match[2]));
    else if (project_.paths.count(span) > 0 || (std::regex_match(span, path) && startsAtTop(span)))
      checkPath(span.ends_with('/') ? span.substr(0, span.size() - 1) : span);
    else if (std::regex_match(span, match, quoted))
      checkTest(match[1]);
    else if (std::regex_match(span, match, identifier))
      checkWord(match[1]);
    else if (std::regex_match(span, option))
      checkWord(span);
  }

  bool startsAtTop(const std::string& span) const {
    return project_.paths.count(span.substr(0, span.find('/'))) > 0;
  }
  void checkPath(const std::string& path) {
    if (project_.tests.count(path) > 0) testSource_ = path;
    const bool isModule = project_.paths.count(path + ".h") > 0 || project_.paths.count(path + ".cpp") > 0;
    if (project_.paths.count(path) == 0 && !isModule) tell("there is no file " + path);
  }
  void endPlace() {
    if (!at_.empty()) tell("behind " + at_ + ":" + std::to_string(number_) + " stands no name");
    at_.clear();
  }
  void checkPlace(const std::string& path, std::size_t number) {
    endPlace();
    if (project_.linesOf.count(path) == 0) return tell("there is no source " + path);
    at_ = path;
    number_ = number;
  }
  void checkNameAtPlace(const std::string& name) {
    const std::string path = std::exchange(at_, {});
    const std::vector<std::string>& lines = project_.linesOf.at(path);
    if (number_ >= 1 && number_ <= lines.size() && hasWord(lines[number_ - 1], name)) return;
    std::string found;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (hasWord(lines[i], name)) found += (found.empty() ? "" : ", ") + std::to_string(i + 1);
    tell(path + ":" + std::to_string(number_) + " does not say " + name + ", which stands on " +
         (found.empty() ? "no line there" : "line " + found));
  }
  void checkTest(const std::string& name) {
    if (!testSource_.empty()) {
      if (project_.tests.at(testSource_).count(name) == 0)
        tell("there is no test \"" + name + "\" in " + testSource_);
      return;
    }
    const bool any = std::any_of(project_.tests.begin(), project_.tests.end(),
                                 [&](const auto& source) { return source.second.count(name) > 0; });
    if (!any) tell("there is no test \"" + name + "\"");
  }
  void checkWord(const std::string& word) {
    if (!at_.empty()) return checkNameAtPlace(word);
    const auto source = project_.wordsOf.find(withoutEnding(list_));
    if (project_.words.count(word) == 0)
      tell("nothing is called " + word);
    else if (source != project_.wordsOf.end() && source->second.count(word) == 0)
      tell("nothing is called " + word + " in " + list_);
  }

  const Project& project_;
  std::string place_;
  std::vector<std::string>& broken_;
  std::string testSource_;
  std::string at_;  // the source of which a line was named that has to hold the next name
  std::size_t number_ = 0;
  std::string before_, list_;  // the span before; what stands before the colon of the list that it is in
};

}  // namespace

Project readProject(const std::string& root) {
  Project project;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator(); ++it) {
    const std::string path = fs::relative(it->path(), root).generic_string();
    if (it->path().filename().string().front() == '.' || path == "build") {
      it.disable_recursion_pending();
      continue;
    }
    project.paths.insert(path);
    if (!it->is_regular_file() || !isSource(path)) continue;
    const std::string text = textOf(it->path());
    addWords(text, project.words);
    project.linesOf[path] = linesOf(text);
    if (withoutEnding(path) != path) addWords(text, project.wordsOf[withoutEnding(path)]);
    // These tests name tests that are not there.
    if (path.rfind("tests/", 0) != 0 || path.rfind("tests/references/", 0) == 0) continue;
    const std::set<std::string> tests = testsOf(text);
    if (!tests.empty()) project.tests[path] = tests;
  }
  return project;
}

std::vector<std::string> brokenReferences(const Project& project, const std::string& page,
                                          const std::string& text) {
  std::vector<std::string> broken;
  const fs::path folder = fs::path(page).parent_path();
  std::istringstream lines(text);
  std::string line;
  bool inBlock = false;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.rfind("```", 0) == 0) inBlock = !inBlock;
    if (inBlock || line.rfind("    ", 0) == 0) continue;
    Line checked(project, page + ":" + std::to_string(number), broken);
    checked.check(line);
    checked.checkLinks(line, folder);
  }
  return broken;
}

}  // namespace handlebody::test
