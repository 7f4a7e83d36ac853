#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/cli/command.h"
#include "app/cli/export_options.h"
#include "app/cli/outputs.h"
#include "app/cli/progress.h"
#include "app/cli/run.h"
#include "app/cli/tunnel_text.h"
#include "core/cancellation.h"
#include "core/collision/certify.h"
#include "core/evolution/edit_step.h"
#include "core/io/atomic_file.h"
#include "core/io/meshes/mesh_io.h"
#include "core/io/report/edit_json.h"
#include "core/io/report/option_error.h"
#include "core/io/report/parse.h"
#include "core/io/report/polished_export.h"
#include "core/io/report/result.h"
#include "core/io/tetrahedra/tetrahedra.h"
#include "core/polish/patch_search.h"
#include "core/told_error.h"
#include "core/version.h"

namespace handlebody::cli {

namespace {

//! Which bad triangles are bettered: those that an edit made, all, none.
enum class Polish { edits, all, off };

struct EditOptions {
  std::string path;
  std::vector<std::string> results, closing;
  std::string report;
  std::optional<double> shorterThan;
  TunnelCut cut = TunnelCut::shorter;
  std::optional<CoordinateSpace> space;
  std::vector<std::pair<std::string, MeshEdit>> touches;  // by option and text, in the order given
  std::optional<Polish> polish;                           // none: as Polish::edits
  std::optional<double> mesherSeconds;
  bool keepLargest = false, fillCavities = false, json = false, quiet = false, isAnonymous = false;

  bool edits() const {
    return !touches.empty() || shorterThan || keepLargest || fillCavities || polish == Polish::all;
  }
};

//! What there is in a mesh.
struct Contents {
  Certificate certificate;
  std::vector<Piece> pieces;
  TunnelList tunnels;
};

Contents contentsOf(const Mesh& mesh, const Certificate& certificate) {
  return {certificate, listPieces(mesh), findTunnels(mesh)};
}

Json contentsToJson(const Contents& c) {
  return {{"mesh", certificateToJson(c.certificate)},
          {"components", piecesToJson(c.pieces)},
          {"tunnels", tunnelsToJson(c.tunnels)},
          {"tunnels_not_listed", c.tunnels.unlisted}};
}

//! What the command did.
struct Edited {
  std::vector<Event> edits;
  TunnelsClosed closed;
  std::optional<PolishReport> polish;
};

//! Throws UsageError if it is refused.
Event touch(Mesh& mesh, const std::string& option, const MeshEdit& edit) {
  TouchedMesh done = touched(mesh, edit);
  if (!done.isDone()) {
    std::string why = sentence(done.refusal);
    why[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(why[0])));
    throw Told<UsageError>(Finding(done.refusal), option + ": " + why + ".");
  }
  mesh = std::move(done.mesh);
  return eventOf(edit, done);
}

//! Local edits go first, then pieces: what is gone has no tunnels.
Edited edit(Mesh& mesh, const EditOptions& o) {
  Edited out;
  const auto add = [&out](const std::vector<Event>& more) {
    out.edits.insert(out.edits.end(), more.begin(), more.end());
  };
  for (const auto& [option, wanted] : o.touches) out.edits.push_back(touch(mesh, option, wanted));
  if (o.keepLargest) add(keepLargest(mesh));
  if (o.fillCavities) add(fillCavities(mesh));
  if (o.shorterThan) {
    out.closed = closeTunnels(mesh, *o.shorterThan, o.cut);
    add(out.closed.edits);
  }
  return out;
}

void printEdits(const Edited& done) {
  for (const Event& e : done.edits) std::printf("%s\n", editText(e).c_str());
  const std::string polished = done.polish ? polishText(*done.polish) : std::string();
  if (!polished.empty()) std::printf("%s\n", polished.c_str());
  if (done.edits.empty() && polished.empty()) std::printf("nothing to change\n");
}

void printContents(const Contents& c) {
  std::printf("%s", piecesText(c.pieces).c_str());
  std::printf("%s", tunnelsText(c.tunnels).c_str());
}

void warn(const Edited& done) {
  for (const OpenTunnel& t : done.closed.open)
    std::fprintf(
        stderr,
        "handlebody-cli: warning: the tunnel at %.4g,%.4g,%.4g (%.4g mm round it, %.4g mm around its "
        "handle) is still open: no cap fits.\n",
        t.location.x(), t.location.y(), t.location.z(), t.tunnelLength, t.handleLength);
  if (done.closed.unlisted > 0)
    std::fprintf(stderr,
                 "handlebody-cli: warning: for %d tunnels no loops were found; they are still open.\n",
                 done.closed.unlisted);
}

Json answer(const EditOptions& o, const Contents& before, const Edited& done,
            const std::optional<Contents>& after) {
  Json json = {
      {"version", HANDLEBODY_VERSION}, {"notice", kNotice}, {"input", o.isAnonymous ? "MESH" : o.path}};
  json["before"] = contentsToJson(before);
  if (!after) return json;
  Json& edits = json["edits"] = Json::array();
  for (const Event& e : done.edits) edits.push_back(editToJson(e));
  if (done.polish) json["polish"] = polishToJson(*done.polish);
  Json& open = json["still_open"] = Json::array();
  for (const OpenTunnel& t : done.closed.open) open.push_back(openTunnelToJson(t));
  json["after"] = contentsToJson(*after);
  return json;
}

void checkOptions(const EditOptions& o) {
  if (o.path.empty()) throw UsageError("MESH is required.");
  if (o.edits() && o.results.empty()) throw UsageError("-o: an edit needs a file to write.");
  if (o.results.empty() && (o.space || o.polish))
    throw OptionError(o.space ? "--space" : "--polish", "has no effect without -o: nothing is written.", " ");
  if (!o.edits() && !o.results.empty())
    throw UsageError(
        "-o: there is no edit to write; see --close-tunnels, --keep-largest, --fill-cavities, --smooth-here, "
        "--pull, --cut-plane and --polish all.");
  if (o.cut != TunnelCut::shorter && !o.shorterThan) throw UsageError("--cut goes with --close-tunnels.");
  std::vector<OutputFile> files;
  for (const std::string& path : o.results) {
    files.push_back({"-o", path});
    checkSurfaceExtension(files.back());
    checkResult(path, {});
  }
  checkSpace(o.space, o.results);
  checkEffect({}, o.mesherSeconds, o.results);
  if (!o.report.empty()) files.push_back({"--report", o.report});
  checkWritable(files, {o.path});
}

//! Without points that belong to no face, as `check` does not count them either. Throws InputError unless it
//! passes the certificate.
Mesh readValid(const std::string& path, Certificate& certificate) {
  const TriangleSoup soup = readMesh(path);
  certificate = certify(soup);
  if (!certificate.passes())
    throw InputError(path +
                     " does not pass `check`; only a closed, manifold, oriented mesh without "
                     "self-intersections can be looked at or edited.");
  return Mesh(withoutLoosePoints(soup));
}

//! The mesh as it will be written. Throws if it would not be what the edits promise.
CertifiedMesh certified(const EditOptions& o, const Mesh& mesh, const Certificate& before) {
  if (before.misplaced > 0 && examine(mesh).misplaced > 0)
    throw InputError(o.path +
                     ": components lie directly in each other, or cavities outside of any body; nothing "
                     "was written (--keep-largest leaves one body).");
  return certifiedForExport(mesh.compact());
}

//! Per triangle of the mesh: 1 if the one before had none with the same corners.
std::vector<char> newTriangles(const TriangleSoup& mesh, const TriangleSoup& before) {
  using Corners = std::array<double, 9>;
  const auto cornersOf = [](const TriangleSoup& of, const Triangle& t) {
    std::array<std::array<double, 3>, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 p = inSingle(of.points[t[i]]);
      corners[i] = {p.x(), p.y(), p.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    Corners place{};
    for (std::size_t i = 0; i < 9; ++i) place[i] = corners[i / 3][i % 3];
    return place;
  };
  std::vector<Corners> known;
  for (const Triangle& t : before.triangles) known.push_back(cornersOf(before, t));
  std::sort(known.begin(), known.end());
  std::vector<char> isNew;
  for (const Triangle& t : mesh.triangles)
    isNew.push_back(std::binary_search(known.begin(), known.end(), cornersOf(mesh, t)) ? 0 : 1);
  return isNew;
}

void polish(CertifiedMesh& made, const TriangleSoup& before, const EditOptions& o, Edited& done) {
  if (o.polish == Polish::off) return;
  PolishOptions options;
  options.bounds.distance = polishDistance(before);
  if (o.polish != Polish::all) options.isOwn = newTriangles(made.mesh, before);
  done.polish = handlebody::polish(made, options);
  warnOfPolish(*done.polish);
}

int look(const EditOptions& o, const Mesh& mesh, const Certificate& certificate) {
  const Contents contents = contentsOf(mesh, certificate);
  const std::string json = jsonText(answer(o, contents, {}, std::nullopt));
  if (!o.report.empty()) writeTextAtomically(o.report, json);
  if (o.json)
    std::fputs(json.c_str(), stdout);
  else if (!o.quiet)
    printContents(contents);
  return kDone;
}

int editMesh(const EditOptions& o) {
  checkOptions(o);
  const PhaseLine line(o.quiet);
  Certificate certificate;
  Mesh mesh = readValid(o.path, certificate);
  if (!o.edits()) return look(o, mesh, certificate);
  const bool listed = o.json || !o.report.empty();
  const Contents before = listed ? contentsOf(mesh, certificate) : Contents{certificate, {}, {}};
  const TriangleSoup input = mesh.compact();
  Edited done = edit(mesh, o);
  CertifiedMesh out = certified(o, mesh, certificate);
  polish(out, input, o, done);
  std::optional<Contents> after;
  if (listed) after = contentsOf(Mesh(out.mesh), out.certificate);
  warn(done);
  const std::string json = listed ? jsonText(answer(o, before, done, after)) : std::string();
  {
    const DeferSignals whole;
    const CancelScope scope(DeferSignals::stopToken());
    const ExportContext context{
        {}, o.space.value_or(CoordinateSpace::lps), {}, {}, o.mesherSeconds.value_or(kMesherSeconds)};
    writeResults({{ObjectLabel(), out.mesh}}, context, o.results);
    if (!o.report.empty()) writeTextAtomically(o.report, json);
  }
  if (o.json)
    std::fputs(json.c_str(), stdout);
  else if (!o.quiet) {
    printEdits(done);
    std::printf("%s\n", changeText(certificate, out.certificate).c_str());
  }
  return done.closed.open.empty() && done.closed.unlisted == 0 ? kDone : kIncomplete;
}

//! "shorter-than MM" or "MM". The parser takes what follows, too: it may be MESH.
void setClosing(EditOptions& o) {
  if (o.closing.empty()) return;
  std::vector<std::string> words = o.closing;
  if (words.front() == "shorter-than") {
    words.erase(words.begin());
    if (words.empty()) throw UsageError("--close-tunnels shorter-than needs a length in mm.");
  } else if (words.size() == 2) {
    if (!o.path.empty()) throw OptionError("--close-tunnels", "'" + words.front() + "' is not shorter-than.");
    o.path = words.back();
  }
  const double length = parseNumber("--close-tunnels", words.front());
  if (!(length > 0)) throw OptionError("--close-tunnels", "'" + words.front() + "' is not above 0.");
  o.shorterThan = length;
}

void setCut(EditOptions& o, const std::string& text) {
  if (text == "shorter")
    o.cut = TunnelCut::shorter;
  else if (text == "handle")
    o.cut = TunnelCut::handle;
  else if (text == "tunnel")
    o.cut = TunnelCut::tunnel;
  else
    throw OptionError("--cut", "'" + text + "' is not shorter, handle or tunnel.");
}

void setPolish(EditOptions& o, const std::string& text) {
  if (text == "edits")
    o.polish = Polish::edits;
  else if (text == "all")
    o.polish = Polish::all;
  else if (text == "off")
    o.polish = Polish::off;
  else
    throw OptionError("--polish", "'" + text + "' is not edits, all or off.");
}

struct TouchOption {
  const char* name;
  const char* type;
  const char* help;
  MeshEdit (*parse)(const std::string&, const std::string&);
};

const std::array<TouchOption, 3> kTouches{
    {{"--smooth-here", "X,Y,Z,R",
      "Smooth the surface in that ball (LPS millimetres), less towards its rim; the volume stays",
      parseSmoothing},
     {"--pull", "X,Y,Z,X2,Y2,Z2,R",
      "Pull the point of the surface nearest to the first place to the second, and what lies within R mm "
      "along the surface with it, falling off",
      parsePull},
     {"--cut-plane", "X,Y,Z,NX,NY,NZ[,R][,SIDE]",
      "Cut along the plane through that place with that normal and cap both sides flat; only within R mm of "
      "the place; SIDE that stays: both (default), positive, negative",
      parsePlaneCut}}};

void addTouches(CLI::App& command) {
  for (const TouchOption& touch : kTouches)
    command.add_option(touch.name, touch.help)
        ->type_name(touch.type)
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
}

//! The local edits in the order in which they stand on the command line.
void setTouches(EditOptions& o, const CLI::App& command) {
  std::array<std::size_t, kTouches.size()> used{};
  for (const CLI::Option* option : command.parse_order())
    for (std::size_t i = 0; i < kTouches.size(); ++i) {
      if (!option->check_name(kTouches[i].name)) continue;
      const std::string text = option->results().at(used[i]++);
      o.touches.emplace_back(kTouches[i].name + (" " + text), kTouches[i].parse(kTouches[i].name, text));
    }
}

void addEdits(CLI::App& command, EditOptions& o) {
  command
      .add_option("--close-tunnels", o.closing,
                  "Cut and cap along each tunnel's loop of less than MM millimetres (inf: all)")
      ->type_name("[shorter-than] MM")
      ->expected(1, 2);
  command
      .add_option_function<std::string>(
          "--cut", [&o](const std::string& text) { setCut(o, text); },
          "Which loop of a tunnel: the one round the tunnel (fills it), the one around its handle (cuts it), "
          "or the "
          "shorter (default)")
      ->type_name("shorter|handle|tunnel");
  command.add_flag("--keep-largest", o.keepLargest,
                   "Remove every body but the largest, which keeps its cavities");
  command.add_flag("--fill-cavities", o.fillCavities, "Remove the cavities, with what lies in them");
}

void addPolish(CLI::App& command, EditOptions& o) {
  command
      .add_option_function<std::string>(
          "--polish", [&o](const std::string& text) { setPolish(o, text); },
          "Better triangles with an angle under 15 degrees and edges whose faces meet at less than 20, with "
          "the surface kept within a tenth of the median edge: those that the edits made (default), all, or "
          "none")
      ->type_name("edits|all|off");
}

}  // namespace

void addEdit(CLI::App& app, Action& action) {
  CLI::App* command = addCommand(
      app, "edit",
      "Tunnels, components and cavities of a mesh: lists them; with -o, closes, removes and fills them, "
      "smooths, pulls and cuts");
  auto options = std::make_shared<EditOptions>();
  command->add_option("MESH", options->path,
                      "A .stl, .vtp, .ply, .obj, .3mf or .stl.dcm file that passes `check`");
  addEdits(*command, *options);
  addTouches(*command);
  addPolish(*command, *options);
  command
      ->add_option("-o,--output", options->results,
                   "The edited mesh: .stl .vtp .ply .obj .3mf .gltf; where gmsh or TetGen is installed .msh "
                   ".vtu .inp, tetrahedra for a solver; may be given several times")
      ->type_name("OUT")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--report", options->report, "What there was, what was done, what there is (JSON)")
      ->type_name("F.json");
  addSpace(*command, options->space);
  addMesherSeconds(*command, options->mesherSeconds);
  addAnonymous(*command, options->isAnonymous);
  command->add_flag("--json", options->json, "The same on standard output");
  command->add_flag("--quiet", options->quiet, "No progress and no summary");
  command->callback([&action, options, command] {
    setTouches(*options, *command);
    action = [options] {
      setClosing(*options);
      return editMesh(*options);
    };
  });
}

}  // namespace handlebody::cli
