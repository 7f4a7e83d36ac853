// The subcommand `batch`, through the real executable: what is refused, what is kept, and what becomes of it
// when processes are killed.

#include <signal.h>
#include <sys/stat.h>

#include "tests/app/batch_study.h"

using namespace handlebody::test;
namespace fs = std::filesystem;

namespace {

void removeTemporaries(const Study& study) {
  for (const auto& entry : fs::directory_iterator(study.out + "/cases"))
    if (entry.path().filename().string().rfind(".tmp-", 0) == 0) fs::remove_all(entry.path());
}

bool isGone(int process) {  // or waits to be buried
  const std::string path = "/proc/" + std::to_string(process) + "/stat";
  if (!fs::exists(path)) return true;
  const std::string stat = readBytes(path);
  return stat.find(") Z") != std::string::npos;
}

}  // namespace

TEST_CASE("a batch gives the same bits as single runs, with any number of jobs", "[batch]") {
  const Study s;
  writeBytes(s.csv, "\xef\xbb\xbf" + kHeader + ",output,smoothing\r\n" + s.row("a", ",mesh.stl;l.nii.gz,") +
                        s.row("b", ",mesh.stl,0.5"));
  const Outcome outcome = s.run({"--jobs", "2"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  const std::string mesh = s.folder / "single.stl", labels = s.folder / "single.nii.gz";
  REQUIRE(runCli({"segment", s.phantom.path, "--seed", s.phantom.seed, "-o", mesh, "-o", labels}).exitCode ==
          0);
  CHECK(readBytes(mesh) == readBytes(s.file("a")));
  CHECK(readBytes(labels) == readBytes(s.file("a", "l.nii.gz")));
  REQUIRE(runCli({"segment", s.phantom.path, "--seed", s.phantom.seed, "--smoothing", "0.5", "-o", mesh})
              .exitCode == 0);
  CHECK(readBytes(mesh) == readBytes(s.file("b")));
  CHECK(runCli({"replay", s.file("a", "session.json"), "-o", mesh}).exitCode == 0);  // it finds its volume
  CHECK(readBytes(mesh) == readBytes(s.file("a")));
}

TEST_CASE("a batch keeps what is done and repeats what has changed", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + ",curvature\n" + s.row("a", ",") + s.row("b", ",0.2"));
  REQUIRE(s.run().exitCode == 0);
  const ino_t a = identity(s.out + "/cases/a"), b = identity(s.out + "/cases/b");
  const std::string before = readBytes(s.out + "/summary.csv");

  CHECK(s.run().out.find("2 done (2 of them before)") == 0);
  CHECK(readBytes(s.out + "/summary.csv") == before);
  writeBytes(s.csv, kHeader + ",curvature\n" + s.row("a", ",") + s.row("b", ",0.3"));
  CHECK(s.run().out.find("2 done (1 of them before)") == 0);
  CHECK(identity(s.out + "/cases/a") == a);
  CHECK(identity(s.out + "/cases/b") != b);

  SECTION("a result that was tampered with is made again") {
    fs::resize_file(s.file("a"), 100);
    CHECK(s.run().out.find("2 done (1 of them before)") == 0);
    CHECK(fs::file_size(s.file("a")) > 100);
  }
  SECTION("other voxels under the same name") {
    makePhantomFile(s.folder, "sphere.mha", {"--noise", "0.05"});
    CHECK(s.run().out.find("2 done (0 of them before)") == 0);
  }
  SECTION("a record that is damaged") {
    writeBytes(s.file("a", "case.json"), "{\"request\": 3");
    CHECK(s.run().out.find("2 done (1 of them before)") == 0);
  }
  expectWholeResults(s, 2);
}

TEST_CASE("every bad row is a row with line, column and sentence, and the others run", "[batch]") {
  const Study s;
  REQUIRE(mkfifo((s.folder / "pipe.mha").c_str(), 0600) == 0);
  writeBytes(s.csv, kHeader + ",object,time-limit,anonymous,output\n" + s.row("good", ",,,,") +
                        "gone,nothing.mha,\"1,1,1\",,,,\n" + s.row("purple", ",purple,,,") +
                        s.row("good", ",,,,") + "no-seed,sphere.mha,,,,,\n" + s.row("../up", ",,,,") +
                        s.row("=1+1", ",,,,") + s.row("late", ",,soon,,") + s.row("flag", ",,,maybe,") +
                        s.row("ending", ",,,,x.doc") + s.row("slash", ",,,,../x.stl") +
                        "pipe,pipe.mha,\"1,1,1\",,,,\n" + "raw,sphere.mha,\"1,1\"x,,,,\n" +
                        "extra,sphere.mha,\"1,1,1\",,,,,more\n" + ",sphere.mha,\"1,1,1\",,,,\n");
  const Outcome outcome = s.run();
  CHECK(outcome.exitCode == kIncomplete);
  const auto cases = s.summary().at("cases");
  REQUIRE(cases.size() == 15);
  CHECK(cases[0]["status"] == "done");
  const std::vector<std::pair<int, std::string>> expected{
      {3, ", column 2 (volume): "},
      {4, ", column 4 (object): 'purple' is not auto, dark or bright."},
      {5, ": 'good' is the name of the case of line 2, too."},
      {6, ": segment needs a --seed"},
      {7, ", column 1 (case): '../up'"},
      {8, ", column 1 (case): '=1+1'"},
      {9, ", column 5 (time-limit): 'soon'"},
      {10, ", column 6 (anonymous): 'maybe'"},
      {11, ", column 7 (output): x.doc: unknown extension"},
      {12, ", column 7 (output): '../x.stl'"},
      {13, ", column 2 (volume): "},
      {14, ", column 3 (seed): "},
      {15, ", column 8: "},
      {16, ", column 1 (case): "}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string message = cases[i + 1]["message"];
    CHECK(cases[i + 1]["status"] == "refused");
    CHECK(message.find("line " + std::to_string(expected[i].first) + expected[i].second) == 0);
    CHECK(message.back() == '.');
    CHECK(outcome.err.find(message) != std::string::npos);
  }
  expectWholeResults(s, 1);
}

TEST_CASE("names and values of any text and length are rows with a sentence of one line", "[batch]") {
  const Study s;
  const std::string longest(90000, 'x');
  writeBytes(s.csv, kHeader + "\n" + s.row("Köln 北京 “ß”") + longest + ",sphere.mha,\"1,1,1\"\n" +
                        "value,sphere.mha," + longest + "\n" + "more,sphere.mha," + std::string(200000, '7') +
                        "\n" + "volume,/" + longest + ",\"1,1,1\"\n" + "CON\x1b[2J,sphere.mha,\"1,1,1\"\n" +
                        "\"<b>&\"\"'\",sphere.mha,\"" + s.phantom.seed + "\"\n");
  const Outcome outcome = s.run();
  CHECK(outcome.exitCode == kIncomplete);
  const auto cases = s.summary().at("cases");
  REQUIRE(cases.size() == 7);
  for (const std::size_t good : {0U, 6U}) CHECK(cases[good].at("status") == "done");
  CHECK(fs::exists(s.file("<b>&\"'")));
  for (const std::size_t bad : {1U, 2U, 3U, 4U, 5U}) {
    INFO(bad);
    CHECK(cases[bad].at("status") == "refused");
    CHECK(cases[bad].at("message").get<std::string>().size() < 600);
  }
  CHECK(outcome.err.size() < 6000);
  CHECK(outcome.err.find('\x1b') == std::string::npos);
  const std::string page = readBytes(s.out + "/index.html");
  CHECK(page.find("<b>") == std::string::npos);
  CHECK(page.find("href=\"cases/%3Cb%3E%26%22%27/mesh.stl\"") != std::string::npos);
}

TEST_CASE("a command line that the system does not take is the case's failure", "[batch]") {
  const Study s;
  std::string seeds;
  for (int i = 0; i < 2000; ++i) seeds += s.phantom.seed + ";";
  std::string header = kHeader, row = "long,sphere.mha";
  for (int i = 0; i < 100; ++i) row += ",\"" + seeds.substr(0, seeds.rfind(';', 99000)) + "\"";
  for (int i = 1; i < 100; ++i) header += ",seed";
  writeBytes(s.csv, header + "\n" + row + "\n" + s.row("works"));
  CHECK(s.run().exitCode == kIncomplete);
  CHECK(s.row(0).at("status") == "failed");
  CHECK(s.row(0).at("message") == "its options are longer than the system takes.");
  CHECK(s.row(1).at("status") == "done");
}

TEST_CASE("the tables tell a case as soon as it has ended", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a") + s.row("b"));
  RunningCli batch(s.arguments());
  REQUIRE(waitUntil([&] { return fs::exists(s.file("a", "case.json")); }));
  kill(batch.waitForChild(), SIGSTOP);  // the second: nothing ends any more
  CHECK(waitUntil([&] { return fs::exists(s.out + "/summary.json"); }, 5));
  CHECK(s.row(0).at("status") == "done");
  CHECK(s.row(0).at("measures").at("largest_diameter_mm").get<double>() > 0);
  kill(batch.process(), SIGKILL);
}

TEST_CASE("a table that cannot be written for a while is told once, and ends no case", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a") + s.row("b") + s.row("c"));
  const std::string table = s.out + "/summary.csv";
  REQUIRE(s.run({"--only-summary"}).exitCode == kIncomplete);  // the folder is a batch's
  fs::remove(table);
  fs::create_directory(table);
  RunningCli batch(s.arguments());
  REQUIRE(waitUntil([&] { return fs::exists(s.file("b", "case.json")); }));
  batch.waitForChild();  // the third: the table has been tried after the first and the second
  fs::remove(table);
  const Outcome outcome = batch.wait();
  INFO(outcome.err);
  CHECK(outcome.exitCode == 0);
  const std::size_t told = outcome.err.find("summary.csv: ");
  CHECK(told != std::string::npos);
  CHECK(outcome.err.find("summary.csv: ", told + 1) == std::string::npos);
  CHECK(fs::is_regular_file(table));
  expectWholeResults(s, 3);
}

TEST_CASE("a study that cannot be told is refused whole, before anything is made", "[batch]") {
  const Study s;
  for (const std::string text :
       {"", "case,volume,seed\n", "case,seed\na,\"1,1,1\"\n", "case,volume,sed\na,b,c\n",
        "case;volume;seed\na;b;c\n", "volume,volume\na,b\n", "case,name,volume\na,b,c\n",
        "volume,output,report\na,b,c\n", "case,volume\n\"a,b\n"}) {
    INFO(text);
    writeBytes(s.csv, text);
    const Outcome outcome = s.run();
    CHECK(outcome.exitCode == 3);
    CHECK(outcome.err.find("study.csv: ") != std::string::npos);
    CHECK_FALSE(fs::exists(s.out));
  }
  CHECK(runCli({"batch", s.folder / "none.csv", "-o", s.out}).exitCode == 3);
  CHECK(s.run({"--jobs", "0"}).exitCode == 2);
}

TEST_CASE("a study may be named without its folder", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a"));
  const fs::path before = fs::current_path();
  fs::current_path(s.folder.path());
  const Outcome outcome = runCli({"batch", "study.csv", "-o", "out"});
  const Outcome summary = runCli({"batch", "study.csv", "-o", "out", "--relative-to", ".", "--only-summary"});
  fs::current_path(before);
  CHECK(outcome.exitCode == 0);
  CHECK(summary.exitCode == 0);
}

TEST_CASE("two full stops behind a link lead out of the folder that it leads to, as for the system",
          "[batch]") {
  const Study s;
  const std::string text = "case,volume,seed\na,../scans/a.mha,\"" + s.phantom.seed + "\"\n";
  for (const std::string folder : {"disk/study", "disk/scans", "home/scans"})
    fs::create_directories(s.folder / folder);
  fs::create_directory_symlink(s.folder / "disk/study", s.folder / "home/study");
  fs::copy_file(s.phantom.path, s.folder / "disk/scans/whole.mha");
  fs::create_symlink("whole.mha", s.folder / "disk/scans/a.mha");
  makePhantomFile(s.folder, "home/scans/a.mha", {"--noise", "0.05"});
  writeBytes(s.folder / "disk/study/study.csv", text);
  const Outcome outcome =
      runCli({"batch", s.folder / "home/study/study.csv", "-o", s.folder / "home/study/../out"});
  INFO(outcome.err);
  REQUIRE(outcome.exitCode == 0);
  CHECK_FALSE(fs::exists(s.folder / "home/out"));
  const auto report = nlohmann::json::parse(readBytes(s.folder / "disk/out/cases/a/report.json"));
  const std::string read = report.at("input").at("path");
  CHECK(fs::equivalent(read, s.folder / "disk/scans/a.mha"));
  CHECK(fs::path(read).filename() == "a.mha");  // a link to a file keeps its name
}

TEST_CASE("the format and the folder of relative paths can be chosen for all rows", "[batch]") {
  const Study s;
  writeBytes(s.folder / "elsewhere.csv", kHeader + ",output\n" + s.row("a", ",") + s.row("b", ",b.obj"));
  fs::create_directory(s.folder / "tables");
  fs::rename(s.folder / "elsewhere.csv", s.folder / "tables/study.csv");
  const std::vector<std::string> words{"batch", s.folder / "tables/study.csv", "-o", s.out, "-f"};
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return runCli(all);
  };
  CHECK(run({"doc"}).exitCode == 2);
  CHECK(run({""}).exitCode == 2);
  CHECK_FALSE(fs::exists(s.out));
  CHECK(run({".ply"}).exitCode == kIncomplete);
  CHECK(run({".ply", "--relative-to", s.folder.path()}).exitCode == 0);
  CHECK(fs::exists(s.file("a", "mesh.ply")));
  CHECK(fs::exists(s.file("b", "b.obj")));
}

TEST_CASE("a case without a name is called after its file without the extension, or its whole folder",
          "[batch]") {
  const Study s;
  std::string rows = "volume,seed\n";
  for (const std::string series : {"1.2.840.1", "1.2.840.2/"}) {
    fs::create_directories(s.folder / ("scans/" + series));
    rows += "scans/" + series + ",\"" + s.phantom.seed + "\"\n";
  }
  writeBytes(s.csv, rows + "sphere.mha,\"" + s.phantom.seed + "\"\n");
  s.run({"--only-summary"});
  CHECK(s.row(0).at("case") == "1.2.840.1");
  CHECK(s.row(1).at("case") == "1.2.840.2");
  CHECK(s.row(2).at("case") == "sphere");
  for (std::size_t i = 0; i < 3; ++i) CHECK(s.row(i).at("status") != "refused");
}

TEST_CASE("several seeds in a cell or in columns of one name are several seeds", "[batch]") {
  const Study s;
  writeBytes(s.csv, "volume,seed,seed\nsphere.mha,\"" + s.phantom.seed + " ; 40,40,40,4\",\"44,40,40,4\"\n");
  REQUIRE(s.run().exitCode == 0);
  CHECK(
      nlohmann::json::parse(readBytes(s.file("sphere", "report.json"))).at("requested").at("seeds").size() ==
      3);
}

TEST_CASE("walls are a part of what was asked for, and a surface that is not finished is a result",
          "[batch]") {
  const Study s;
  const auto makeWalls = [&](const std::string& value) {
    REQUIRE(runCli({"segment", s.phantom.path, "--seed", s.phantom.seed, "--label-value", value, "-o",
                    s.folder / "walls.mha"})
                .exitCode == 0);
  };
  makeWalls("1");
  writeBytes(s.csv,
             "case,volume,seed,walls,anonymous,max-iterations\na,sphere.mha,\"8,8,8,4\",walls.mha,yes,2\n");
  REQUIRE(s.run().exitCode == 0);
  CHECK(s.row(0).at("measures").at("stopped") == "max-iterations");
  CHECK(s.run().out.find("1 done (1 of them before)") == 0);
  const std::string session = readBytes(s.file("a", "session.json"));
  CHECK(session.find(s.folder.path()) == std::string::npos);  // anonymous
  CHECK(nlohmann::json::parse(session).at("requested").at("constraints").contains("wall_map"));
  makeWalls("2");
  CHECK(s.run().out.find("1 done (0 of them before)") == 0);
}

TEST_CASE(
    "a surface to begin with is a file of the study: its path is the table's, its content decides what is "
    "done",
    "[batch]") {
  const Study s;
  const auto makeStart = [&](const std::string& iterations) {
    REQUIRE(runCli({"segment", s.phantom.path, "--seed", s.phantom.seed, "--max-iterations", iterations, "-o",
                    s.folder / "start.stl"})
                .exitCode == 5);
  };
  makeStart("2");
  writeBytes(s.csv, "case,volume,start,given\nbegins,sphere.mha,start.stl,\nis,sphere.mha,,start.stl\n");
  REQUIRE(s.run().exitCode == 0);
  CHECK(s.run().out.find("2 done (2 of them before)") == 0);
  makeStart("3");
  CHECK(s.run().out.find("2 done (0 of them before)") == 0);
  fs::remove(s.folder / "start.stl");
  CHECK(s.run().exitCode == kIncomplete);
  CHECK_THAT(s.row(0).at("message").get<std::string>(),
             Contains("start.stl: there is no such file or folder"));
  writeBytes(s.csv, "case,volume,start,start\na,sphere.mha,start.stl,start.stl\n");
  CHECK(s.run().err.find("says the same as column 3") != std::string::npos);
}

TEST_CASE("a case that hangs is stopped at its time limit, and the others run", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + ",time-limit\n" + s.row("hangs", ",4.5") + s.row("works", ","));
  RunningCli batch(s.arguments());
  kill(batch.waitForChild(), SIGSTOP);  // it does nothing any more, whatever it is asked
  CHECK(batch.wait().exitCode == kIncomplete);
  CHECK(s.row(0).at("status") == "failed");
  CHECK(s.row(0).at("message") == "it was stopped at its time limit of 4.5 s.");
  CHECK(s.row(1).at("status") == "done");
  CHECK(s.run().exitCode == 0);
  CHECK_FALSE(fs::exists(s.out + "/failed/hangs.txt"));
  expectWholeResults(s, 2);
}

TEST_CASE("a batch sees its cases end where its parent takes no note of ends", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a"));
  const auto before = signal(SIGCHLD, SIG_IGN);  // a program that is started has it so, too
  RunningCli batch(s.arguments());
  signal(SIGCHLD, before);
  REQUIRE(waitUntil([&] { return fs::exists(s.out + "/index.html"); }));
  CHECK(batch.wait().exitCode == 0);
  expectWholeResults(s, 1);
}

TEST_CASE("a case that is killed or has no memory is a row with its sentence", "[batch]") {
  const Study s;
  // More voxels than "full" may have, which takes no place on the disk.
  writeBytes(s.folder / "full.mha",
             "ObjectType = Image\nNDims = 3\nDimSize = 640 640 640\nElementType = MET_UCHAR\n"
             "ElementDataFile = LOCAL\n");
  fs::resize_file(s.folder / "full.mha", fs::file_size(s.folder / "full.mha") + 640ull * 640 * 640);
  writeBytes(s.csv, kHeader + ",memory-limit\n" + s.row("killed", ",") + s.row("hungry", ",20") +
                        s.row("works", ",") + "full,full.mha,\"1,1,1\",200\n");
  RunningCli batch(s.arguments());
  kill(batch.waitForChild(), SIGKILL);
  CHECK(batch.wait().exitCode == kIncomplete);
  CHECK(s.row(0).at("message").get<std::string>().find("it was killed") == 0);
#ifndef __SANITIZE_ADDRESS__
  CHECK(s.row(1).at("message").get<std::string>().find("20 MB") != std::string::npos);
  CHECK(fs::exists(s.out + "/" + s.row(1).at("log").get<std::string>()));
  CHECK(s.row(3).at("message").get<std::string>().find("200 MB") != std::string::npos);
#endif
  CHECK(s.row(2).at("status") == "done");
  expectWholeResults(s, 4);
}

TEST_CASE("the log of a failure is that of the last, and goes when there is a result", "[batch]") {
  const Study s;
  const std::string log = s.out + "/failed/a.txt";
  const auto runKilled = [&](bool hasLog) {
    RunningCli batch(s.arguments());
    const int child = batch.waitForChild();
    kill(child, SIGSTOP);
    if (!hasLog) fs::remove(s.out + "/cases/.tmp-a/log.txt");
    kill(child, SIGKILL);
    CHECK(batch.wait().exitCode == kIncomplete);
  };
  writeBytes(s.csv, kHeader + ",smoothing\n" + s.row("a", ",0.5"));
  REQUIRE(s.run().exitCode == 0);
  writeBytes(s.csv, kHeader + ",smoothing\n" + s.row("a", ",0.4"));
  runKilled(true);
  CHECK(s.row(0).at("log") == "failed/a.txt");
  CHECK(fs::exists(log));
  SECTION("one that has left none") {
    runKilled(false);
    CHECK(s.row(0).at("status") == "failed");
    CHECK_FALSE(s.row(0).contains("log"));
    CHECK_FALSE(fs::exists(log));  // that was another one's
  }
  SECTION("the options are again those of the result that is there") {
    writeBytes(s.csv, kHeader + ",smoothing\n" + s.row("a", ",0.5"));
    SECTION("in a batch") { CHECK(s.run().out.find("1 done (1 of them before)") == 0); }
    SECTION("as one row") { CHECK(s.run({"--only-row", "1"}).exitCode == 0); }
    CHECK(fs::is_empty(s.out + "/failed"));
  }
}

TEST_CASE("a case does not outlive a batch that is killed", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a"));
  RunningCli batch(s.arguments());
  const int child = batch.waitForChild();
  kill(batch.process(), SIGKILL);
  batch.wait();
  CHECK(waitUntil([child] { return isGone(child); }));
  // Else it has gone on to its end.
  CHECK_FALSE(fs::exists(s.out + "/cases/.tmp-a/report.json"));
  CHECK_FALSE(fs::exists(s.out + "/cases/a"));
}

TEST_CASE("a batch that is killed goes on when it is run again", "[batch]") {
  const Study s;
  std::string text = kHeader + "\n";
  for (const char* name : {"a", "b", "c", "d", "e"}) text += s.row(name);
  writeBytes(s.csv, text);
  std::vector<ino_t> kept;
  {
    RunningCli batch(s.arguments({"--jobs", "2"}));
    REQUIRE(waitUntil([&] { return fs::exists(s.file("a", "case.json")); }));
    const std::vector<int> children{batch.waitForChild()};
    kill(batch.process(), SIGKILL);
    CHECK(batch.wait().exitCode == -SIGKILL);
    for (int child : children) CHECK(waitUntil([child] { return isGone(child); }));
    removeTemporaries(s);
    expectWholeResults(s, 4);  // nothing half-written among what has a name
  }
  const ino_t a = identity(s.out + "/cases/a");
  fs::create_directories(s.out + "/cases/.tmp-e/rest");  // as a batch leaves it that is killed later
  const Outcome again = s.run();
  CHECK(again.exitCode == 0);
  CHECK(again.out.find("5 done (") == 0);
  CHECK(again.out.find("(0 of them before)") == std::string::npos);
  CHECK(identity(s.out + "/cases/a") == a);
  expectWholeResults(s, 5);
}

TEST_CASE("an interrupt stops a batch cleanly", "[batch]") {
  const Study s;
  std::string text = kHeader + "\n";
  for (const char* name : {"a", "b", "c", "d", "e"}) text += s.row(name);
  writeBytes(s.csv, text);
  RunningCli batch(s.arguments());
  REQUIRE(waitUntil([&] { return fs::exists(s.file("a", "case.json")); }));
  const int child = batch.waitForChild();
  kill(batch.process(), SIGINT);
  const Outcome outcome = batch.wait();
  CHECK(outcome.exitCode == -SIGINT);
  CHECK(outcome.out.find("not run") != std::string::npos);
  CHECK(isGone(child));
  expectWholeResults(s, 4);
  CHECK(s.row(0).at("status") == "done");
  CHECK(s.row(4).at("status") == "not run");
}

TEST_CASE("two batches do not work in one folder", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a"));
  RunningCli batch(s.arguments());
  kill(batch.waitForChild(), SIGSTOP);
  const Outcome second = s.run();
  CHECK(second.exitCode == 2);
  CHECK(second.err.find("another batch") != std::string::npos);
}

TEST_CASE("a hundred cases with three bad rows, two kills and a resume", "[.][slow][batch-slow]") {
  const Study s;
  std::string text = kHeader + ",balloon\n";
  for (int i = 0; i < 100; ++i) {
    const std::string weight = i % 33 == 7 ? ",heavy" : "," + std::to_string(1 + i % 5 * 0.1);
    text += s.row("case" + std::to_string(i), weight);
  }
  writeBytes(s.csv, text);
  for (const int after : {20, 60}) {
    RunningCli batch(s.arguments({"--jobs", "2"}));
    REQUIRE(waitUntil([&] { return fs::exists(s.file("case" + std::to_string(after), "case.json")); }, 300));
    kill(batch.process(), SIGKILL);
    batch.wait();
  }
  const Outcome last = s.run({"--jobs", "2"});
  CHECK(last.exitCode == kIncomplete);
  CHECK(std::stoi(last.out.substr(last.out.find('(') + 1)) >=
        58);  // of those before the second kill, none again
  const auto counts = s.summary().at("counts");
  CHECK(counts.at("done") == 97);
  CHECK(counts.at("refused") == 3);
  expectWholeResults(s, 97);
  for (int i = 0; i < 5; ++i) {  // the five kinds of case
    const std::string mesh = s.folder / "single.stl";
    REQUIRE(runCli({"segment", s.phantom.path, "--seed", s.phantom.seed, "--balloon",
                    std::to_string(1 + i * 0.1), "-o", mesh})
                .exitCode == 0);
    for (int j = i; j < 100; j += 5)
      if (j % 33 != 7) CHECK(readBytes(mesh) == readBytes(s.file("case" + std::to_string(j))));
  }
}

TEST_CASE("a batch replaces nothing that no batch has made", "[batch]") {
  const Study s;
  const auto isRefused = [&](const std::string& said) {
    const Outcome outcome = s.run();
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Catch::Matchers::Contains(said));
  };
  writeBytes(s.csv, kHeader + "\n" + s.row("a"));
  const std::string mine = s.out + "/cases/a/notes.txt", page = s.out + "/index.html";
  SECTION("a folder of a case, of which it may be the input") {
    fs::create_directories(s.out + "/cases/a");
    writeBytes(mine, "mine");
    isRefused("'cases'");
    CHECK(readBytes(mine) == "mine");
  }
  SECTION("a page") {
    fs::create_directories(s.out);
    writeBytes(page, "mine");
    isRefused("'index.html'");
    CHECK(readBytes(page) == "mine");
  }
  SECTION("a folder that was put there after a batch, and an input in one") {
    REQUIRE(s.run().exitCode == 0);
    const std::string volume = s.out + "/cases/b/volume.mha";
    fs::create_directories(s.out + "/cases/b");
    fs::copy_file(s.phantom.path, volume);
    writeBytes(s.csv, kHeader + "\n" + s.row("a") + s.row("b"));
    isRefused("cases/b");
    writeBytes(s.csv, kHeader + "\nc,out/cases/b/volume.mha,\"" + s.phantom.seed + "\"\n");
    isRefused("an input must not lie in");
    CHECK(readBytes(volume) == readBytes(s.phantom.path));
  }
}

TEST_CASE("a study in the folder of its results does not bear the name of a table", "[batch]") {
  const Study s;
  REQUIRE(runCli({"batch", s.csv, "-o", s.out}).exitCode != 0);  // there is no study yet
  fs::create_directories(s.out);
  const std::string study = s.out + "/summary.csv",
                    text = kHeader + "\na,../sphere.mha,\"" + s.phantom.seed + "\"\n";
  writeBytes(study, text);
  const Outcome outcome = runCli({"batch", study, "-o", s.out});
  CHECK(outcome.exitCode == 2);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("summary.csv"));
  CHECK(readBytes(study) == text);
}

TEST_CASE("a batch does not write into the folder that is the volume of a row", "[batch]") {
  const Study s;
  const std::string scan = s.folder / "scan";
  fs::create_directory(scan);
  writeBytes(scan + "/slice.dcm", "a file of the volume");
  fs::create_directory_symlink(scan, s.folder / "link");
  for (const std::string volume : {"scan", "scan/", "link"}) {
    INFO(volume);
    writeBytes(s.csv, kHeader + "\na," + volume + ",\"1,1,1\"\n");
    const Outcome outcome = runCli({"batch", s.csv, "-o", scan});
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Contains("an input must not be the folder where the batch writes"));
    CHECK(std::distance(fs::directory_iterator(scan), {}) == 1);  // nothing was made
  }
}

TEST_CASE("what somebody has put beside the results of a case stays when they are made anew", "[batch]") {
  const Study s;
  writeBytes(s.csv, kHeader + ",curvature\n" + s.row("a", ",0.2"));
  REQUIRE(s.run().exitCode == 0);
  fs::create_directories(s.file("a", "pictures"));
  writeBytes(s.file("a", "notes.txt"), "mine");
  writeBytes(s.file("a", "pictures/one.png"), "mine, too");
  writeBytes(s.csv, kHeader + ",curvature\n" + s.row("a", ",0.3"));
  CHECK(s.run().out.find("1 done (0 of them before)") == 0);
  CHECK(readBytes(s.file("a", "notes.txt")) == "mine");
  CHECK(readBytes(s.file("a", "pictures/one.png")) == "mine, too");
}
