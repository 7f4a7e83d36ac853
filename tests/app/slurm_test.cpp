// `batch --slurm` and the parts that its jobs run, with a program in place of sbatch: what is submitted, and
// what becomes of it when jobs are killed, repeated or run at once. For a real Slurm see slurm_cluster.sh.

#include <signal.h>
#include <stdlib.h>

#include <algorithm>

#include "tests/app/batch_study.h"

using namespace handlebody::test;
namespace fs = std::filesystem;

namespace {

//! Notes how it was called, and runs the jobs at once, unless there is a file `hold`. With a file `refuse`
//! that holds N it refuses the N-th job; `interrupt` and `die`: then it sends the batch, or itself, a signal.
const std::string kSbatch = R"sh(#!/bin/bash
cd "$(dirname "$0")"
n=$(($(cat count 2>/dev/null || echo 100) + 1))
if [ -e refuse ] && [ "$n" -ge "$(cat refuse)" ]; then
  echo "sbatch: error: Batch job submission failed: Invalid partition name specified" >&2
  exit 1
fi
[ "$n" = "$(cat die 2>/dev/null)" ] && kill -KILL $$
[ "$n" = "$(cat interrupt 2>/dev/null)" ] && kill -TERM $PPID
echo "$n" > count
printf '%s\n' "$@" > "call-$n"
for word in "$@"; do
  case "$word" in --array=*) tasks=${word#--array=} ;; esac
  script=$word
done
cp "$script" "script-$n"
[ -e hold ] && { echo "$n;cluster"; exit 0; }
if [ -z "$tasks" ]; then
  sh "$script" >> log 2>&1
else
  IFS=,
  for range in ${tasks%%\%*}; do
    for i in $(IFS=' ' seq "${range%-*}" "${range#*-}" | tr '\n' ,); do
      SLURM_ARRAY_TASK_ID=$i sh "$script" >> log 2>&1
    done
  done
fi
echo "$n;cluster"
)sh";

//! A study, and the program that stands for sbatch in front of PATH.
struct SlurmStudy : Study {
  TempFolder bin;
  std::string before = getenv("PATH");

  SlurmStudy() {
    writeBytes(bin / "sbatch", kSbatch);
    fs::permissions(bin / "sbatch", fs::perms::owner_all);
    setenv("PATH", (bin.path() + ":" + before).c_str(), 1);
  }
  ~SlurmStudy() { setenv("PATH", before.c_str(), 1); }

  std::string call(int job) const { return readBytes(bin / "call-" + std::to_string(job)); }
  bool isCalled(int job) const { return fs::exists(bin / "call-" + std::to_string(job)); }
  //! As a task of the job that was held.
  Outcome runTask(int row) const { return run({"--only-row", std::to_string(row)}); }
};

//! A first row whose results are there and whose volume takes a second to hash, so that the batch can be met
//! while it looks for what is done; and one that is done, behind it.
void makeSlowToFind(const Study& s) {
  writeBytes(s.csv, kHeader + "\n" + s.row("slow") + s.row("a"));
  REQUIRE(s.run({"--quiet"}).exitCode == 0);
  constexpr std::uintmax_t kVoxels = 640ull * 640 * 640;  // they take no place on the disk
  const std::string big = s.folder / "big.mha";
  writeBytes(big,
             "ObjectType = Image\nNDims = 3\nDimSize = 640 640 640\nElementType = MET_UCHAR\n"
             "ElementDataFile = LOCAL\n");
  fs::resize_file(big, fs::file_size(big) + kVoxels);
  writeBytes(s.csv, kHeader + "\nslow,big.mha,\"" + s.phantom.seed + "\"\n" + s.row("a"));
}

std::string threeRows(const Study& s) { return kHeader + "\n" + s.row("a") + s.row("b") + s.row("c"); }

}  // namespace

TEST_CASE("a study for Slurm is an array of the rows to do and a summary after it", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.csv, kHeader + ",smoothing\n" + s.row("a", ",") + s.row("it's 100 %", ",0.5") +
                        s.row("bad", ",heavy") + s.row("c", ",0.4") + s.row("d", ",0.6"));
  REQUIRE(s.run({"--only-row", "4"}).exitCode == 0);
  const ino_t c = identity(s.out + "/cases/c");

  const Outcome outcome =
      s.run({"--jobs", "2", "--time-limit", "100", "--slurm", "--partition=long", "-t", "5"});
  INFO(outcome.err);
  CHECK(outcome.exitCode == 0);
  CHECK(outcome.out.find("3 cases submitted as job 101, their summary as job 102: ") == 0);
  CHECK(outcome.err.find("line 4, column 4 (smoothing)") != std::string::npos);
  CHECK(s.call(101).find("\n--partition=long\n-t\n5\n--parsable\n--array=1-2,5%2\n") != std::string::npos);
  CHECK(s.call(102).find("\n--partition=long\n-t\n5\n--parsable\n--dependency=afterany:101\n") !=
        std::string::npos);
  CHECK(readBytes(s.bin / "script-101").find("'--time-limit=100.0'") != std::string::npos);

  CHECK(s.summary().at("counts").at("done") == 4);
  CHECK(s.row(2).at("status") == "refused");
  CHECK(identity(s.out + "/cases/c") == c);
  expectWholeResults(s, 4);
  const std::string single = s.folder / "single.stl";
  REQUIRE(runCli({"segment", s.phantom.path, "--seed", s.phantom.seed, "--smoothing", "0.5", "-o", single})
              .exitCode == 0);
  CHECK(readBytes(single) == readBytes(s.file("it's 100 %")));

  SECTION("a batch by itself keeps what the jobs did") {
    CHECK(s.run().out.find("4 done (4 of them before), 0 failed, 1 refused") == 0);
  }
  SECTION("nothing is submitted where nothing is to do") {
    CHECK(s.run({"--slurm"}).exitCode == kIncomplete);
    CHECK_FALSE(s.isCalled(103));
  }
}

TEST_CASE("jobs run the study as it was when it was submitted", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.csv, threeRows(s));
  writeBytes(s.bin / "hold", "");
  REQUIRE(s.run({"--slurm"}).exitCode == 0);
  CHECK(s.summary().at("counts").at("not run") == 3);
  writeBytes(s.csv, kHeader + "\n" + s.row("other"));
  REQUIRE(system(("SLURM_ARRAY_TASK_ID=2 sh " + s.bin.path() + "/script-101").c_str()) == 0);
  CHECK(fs::exists(s.file("b")));
  CHECK_FALSE(fs::exists(s.file("other")));
}

TEST_CASE("jobs run the table whose rows were numbered, even if it is changed before they are submitted",
          "[slurm]") {
  const SlurmStudy s;
  makeSlowToFind(s);
  writeBytes(s.bin / "hold", "");
  const std::string text = readBytes(s.csv);
  RunningCli batch(s.arguments({"--slurm"}));
  REQUIRE(waitUntil([&] { return catches(batch.process(), SIGTERM); }));
  writeBytes(s.csv, kHeader + "\n" + s.row("other") + text.substr(text.find('\n') + 1));
  CHECK(batch.wait().exitCode == 0);
  CHECK(s.call(101).find("--array=1\n") != std::string::npos);
  CHECK(readBytes(s.out + "/slurm/1/study.csv") == text);
}

TEST_CASE("a summary stays as it was when its making, or a submission, is interrupted", "[slurm]") {
  const SlurmStudy s;
  makeSlowToFind(s);
  const std::string before = readBytes(s.out + "/summary.json");
  for (const std::string option : {"--only-summary", "--slurm"}) {
    INFO(option);
    RunningCli batch(s.arguments({option}));
    REQUIRE(waitUntil([&] { return catches(batch.process(), SIGTERM); }));
    kill(batch.process(), SIGTERM);
    CHECK(batch.wait().exitCode == -SIGTERM);
    CHECK(readBytes(s.out + "/summary.json") == before);
  }
  CHECK_FALSE(s.isCalled(101));
}

TEST_CASE("jobs look for relative paths where the batch was told to", "[slurm]") {
  const SlurmStudy s;
  fs::create_directory(s.folder / "tables");
  writeBytes(s.folder / "tables/study.csv", kHeader + "\n" + s.row("a"));
  const fs::path before = fs::current_path();
  fs::current_path(s.folder.path());
  const Outcome outcome = runCli({"batch", "tables/study.csv", "-o", s.out, "--relative-to", ".", "--slurm"});
  fs::current_path(before);
  INFO(outcome.err);
  CHECK(outcome.exitCode == 0);
  INFO(readBytes(s.bin / "script-101"));
  CHECK(fs::exists(s.file("a")));
}

TEST_CASE("jobs work in the folder that the system finds behind a link", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.csv, kHeader + "\n" + s.row("a"));
  fs::create_directories(s.folder / "disk/study");
  fs::create_directory(s.folder / "home");
  fs::create_directory_symlink(s.folder / "disk/study", s.folder / "home/study");
  const Outcome outcome = runCli({"batch", s.csv, "-o", s.folder / "home/study/../out", "--slurm"});
  INFO(outcome.err);
  CHECK(outcome.exitCode == 0);
  CHECK(fs::exists(s.folder / "disk/out/cases/a/mesh.stl"));
  CHECK_FALSE(fs::exists(s.folder / "home/out"));
}

TEST_CASE("more rows than an array of Slurm holds are several arrays", "[slurm]") {
  const SlurmStudy s;
  std::string text = kHeader + "\n";
  for (int i = 1; i <= 2100; ++i)
    if (i <= 1001 || i > 2000)
      text += s.row("case" + std::to_string(i));
    else
      text += s.row("../x");  // a whole thousand but one that is not to be run
  writeBytes(s.csv, text);
  writeBytes(s.bin / "hold", "");
  CHECK(s.run({"--slurm"}).out.find("1101 cases submitted as job 101, 102, 103, their summary as job 104") ==
        0);
  CHECK(s.call(101).find("--array=1-1000\n") != std::string::npos);
  CHECK(s.call(102).find("--array=1\n") != std::string::npos);
  CHECK(s.call(103).find("--array=1-100\n") != std::string::npos);
  CHECK(readBytes(s.bin / "script-102").find("SLURM_ARRAY_TASK_ID + 1000)") != std::string::npos);
  CHECK(readBytes(s.bin / "script-103").find("SLURM_ARRAY_TASK_ID + 2000)") != std::string::npos);
  CHECK(s.call(104).find("--dependency=afterany:101:102:103\n") != std::string::npos);
}

TEST_CASE("what cannot be submitted is a sentence", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.bin / "hold", "");
  writeBytes(s.csv, threeRows(s));
  const auto refusal = [&](const std::vector<std::string>& more) {
    const Outcome outcome = s.run(more);
    CHECK(outcome.exitCode == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  for (const std::string option :
       {"--array=1-3", "-a1", "--wrap", "--wait", "-W", "--parsable", "--help", "--"})
    CHECK(refusal({"--slurm", option}).find("'" + option + "'") != std::string::npos);
  CHECK_FALSE(s.isCalled(101));
  writeBytes(s.bin / "refuse", "102");
  const std::string second = refusal({"--slurm"});
  CHECK(second.find("Invalid partition name") != std::string::npos);
  CHECK(second.find("Submitted before that: 101") != std::string::npos);
  writeBytes(s.bin / "refuse", "0");
  CHECK(refusal({"--slurm"}).find("Submitted") == std::string::npos);
  writeBytes(s.bin / "sbatch", "#!/bin/sh\necho Hello\n");
  CHECK(refusal({"--slurm"}).find("and said: Hello") != std::string::npos);
  setenv("PATH", s.folder.path().c_str(), 1);
  CHECK(refusal({"--slurm"}).find("no program sbatch") != std::string::npos);
  CHECK(refusal({"--only-row", "9"}).find("3 rows") != std::string::npos);
}

TEST_CASE("a submission that is interrupted tells what it has submitted", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.bin / "hold", "");
  writeBytes(s.csv, threeRows(s));
  SECTION("before the summary") {
    writeBytes(s.bin / "interrupt", "101");
    const Outcome outcome = s.run({"--slurm"});
    CHECK(outcome.exitCode == -SIGTERM);
    CHECK_THAT(outcome.err, Contains("interrupted") && Contains("Submitted before that: 101"));
    CHECK_FALSE(s.isCalled(102));
  }
  SECTION("when all is submitted") {
    writeBytes(s.bin / "interrupt", "102");
    const Outcome outcome = s.run({"--quiet", "--slurm"});
    CHECK(outcome.exitCode == -SIGTERM);
    CHECK(outcome.out.find("3 cases submitted as job 101, their summary as job 102") == 0);
  }
  SECTION("sbatch alone, as it does not hold signals back") {
    writeBytes(s.bin / "die", "102");
    const Outcome outcome = s.run({"--slurm"});
    CHECK(outcome.exitCode == 2);
    CHECK_THAT(outcome.err, Contains("ended by a signal") && Contains("Submitted before that: 101"));
  }
}

TEST_CASE("a case is one process's at a time, and is not done twice", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.csv, threeRows(s));
  RunningCli first(s.arguments({"--only-row", "1"}));
  const int child = first.waitForChild();
  kill(child, SIGSTOP);
  CHECK(s.runTask(1).err.find("case 'a': another process is at work on it.") != std::string::npos);
  CHECK(s.run().err.find("another batch is at work") != std::string::npos);
  CHECK(s.runTask(2).exitCode == 0);  // others go on
  CHECK(s.run({"--only-summary"}).exitCode == kIncomplete);
  CHECK(s.row(0).at("message") == "It is being worked on.");
  CHECK(s.row(1).at("status") == "done");
  kill(child, SIGCONT);
  CHECK(first.wait().exitCode == 0);
  const ino_t a = identity(s.out + "/cases/a");
  CHECK(s.runTask(1).exitCode == 0);
  CHECK(identity(s.out + "/cases/a") == a);
  CHECK(s.runTask(3).exitCode == 0);
  CHECK(s.run({"--only-summary"}).exitCode == 0);
  expectWholeResults(s, 3);
}

TEST_CASE("the summary tells which jobs were killed, and they can be repeated", "[slurm]") {
  const SlurmStudy s;
  writeBytes(s.csv, kHeader + ",time-limit\n" + s.row("killed", ",") + s.row("ended", ",") +
                        s.row("late", ",1") + s.row("waits", ","));
  const auto end = [&](const std::string& row, int signal) {
    RunningCli task(s.arguments({"--only-row", row}));
    const int child = task.waitForChild();
    if (signal == 0) {
      kill(child, SIGSTOP);
      CHECK(task.wait().exitCode == kIncomplete);
      return;
    }
    kill(task.process(), signal);
    CHECK(task.wait().exitCode == -signal);
  };
  end("1", SIGKILL);
  end("2", SIGTERM);
  end("3", 0);
  CHECK(s.run({"--only-summary"}).exitCode == kIncomplete);
  const auto message = [&](std::size_t i) { return s.row(i).at("message").get<std::string>(); };
  CHECK(message(0).find("its process was ended before it was done") == 0);
  CHECK(message(1) == "it was stopped from outside before it was done.");
  CHECK(message(2) == "it was stopped at its time limit of 1 s.");
  CHECK(message(3) == "It has not been run yet.");
  CHECK(s.summary().at("counts").at("failed") == 3);
  for (int i = 1; i <= 2; ++i) CHECK(s.runTask(i).exitCode == 0);
  writeBytes(s.csv, kHeader + ",smoothing\n" + s.row("late", ",0.3"));  // not what has failed
  CHECK(s.run({"--only-summary"}).exitCode == kIncomplete);
  CHECK(s.summary().at("counts").at("failed") == 0);
}
