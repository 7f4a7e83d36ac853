// A simulated user on labelled real volumes: what the regions that clicks choose (core/object) have of the
// object after each click, before any contour grows. Beside peers that are given the same clicks, and with
// any threshold of ObjectPolicy changed.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <thread>

#include "core/object/object_model.h"
#include "tests/bench/clicks/click_peers.h"
#include "tests/bench/clicks/labelled_case.h"
#include "tests/bench/clicks/policy_values.h"

using namespace handlebody;
using namespace handlebody::bench;

namespace {

constexpr double kGood = 0.8;  // Dice

struct Options {
  std::string cases, only;
  int users = 2, clicks = 3, jobs = 2, bestOf = 1;
  unsigned seed = 1;
  bool each = false, peers = false;
  std::vector<std::string> policy, vary;
};

//! Dice of one user after each click.
struct UserRow {
  std::vector<double> dice;
  std::vector<double> seconds;
  double expected = 0;  // after the first
  double best = 0;      // of the first candidates after it, known only from the truth
};

//! Region of cells → voxels.
Mask voxelsOf(const ObjectModel& model, const Grid& grid) {
  Mask out(grid.voxelCount());
  const CellGrid& cells = model.work->cells();
  std::size_t i = 0;
  for (int z = 0; z < grid.size[2]; ++z)
    for (int y = 0; y < grid.size[1]; ++y)
      for (int x = 0; x < grid.size[0]; ++x, ++i) {
        std::array<int, 3> c{x, y, z};
        bool holds = true;
        for (std::size_t a = 0; a < 3; ++a) {
          c[a] = (c[a] - cells.low[a]) / cells.factor[a] - (c[a] < cells.low[a]);
          holds = holds && c[a] >= 0 && c[a] < cells.grid.size[a];
        }
        out[i] = holds && model.region.inside[cells.at(c)];
      }
  return out;
}

//! Voxels, and what Dice the system itself expects (0 if it expects nothing).
struct Answer {
  Mask voxels;
  double expected = 0;
};
//! What a system makes of clicks; the last is the candidate, from 1 on, that is asked for.
using System = std::function<Answer(const Volume&, const std::shared_ptr<const FieldOfView>&,
                                    const std::vector<UserClick>&, int)>;
//! A system for one user: it may keep what it found for earlier clicks.
using SystemMaker = std::function<System()>;

SystemMaker handlebodyWith(const ObjectPolicy& policy) {
  return [policy]() -> System {
    return [finder = std::make_shared<ObjectFinder>(policy)](
               const Volume& volume, const std::shared_ptr<const FieldOfView>& view,
               const std::vector<UserClick>& clicks, int candidate) {
      ObjectQuery query;
      query.candidate = candidate;
      for (const UserClick& c : clicks) (c.isInside ? query.inside : query.outside).push_back({c.place, {}});
      const bool hasView = view && !view->isPaddingNear(volume.grid.toIndex(clicks[0].place));
      const auto model = finder->find(volume, query, hasView ? view : nullptr);
      if (!model) return Answer{Mask(volume.grid.voxelCount()), 0};
      return Answer{voxelsOf(*model, volume.grid), model->candidates[0].score};
    };
  };
}

UserRow oneUser(const LabelledVolume& v, const std::shared_ptr<const FieldOfView>& view, const Vec3& first,
                const Options& o, const SystemMaker& make) {
  const System system = make();
  UserRow row;
  std::vector<UserClick> given{{first, true}};
  for (int k = 0; k < o.clicks; ++k) {
    const auto start = std::chrono::steady_clock::now();
    const Answer answer = system(v.volume, view, given, 1);
    row.seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    row.dice.push_back(diceOf(answer.voxels, v.truth));
    if (k == 0) row.expected = answer.expected;
    UserClick next;
    if (k + 1 == o.clicks || !nextClick(v, answer.voxels, next)) break;
    given.push_back(next);
  }
  row.dice.resize(o.clicks, row.dice.back());
  row.best = row.dice[0];
  for (int c = 2; c <= o.bestOf; ++c)
    row.best = std::max(row.best, diceOf(system(v.volume, view, {{first, true}}, c).voxels, v.truth));
  return row;
}

std::vector<UserRow> allUsers(const LabelledVolume& v, const std::shared_ptr<const FieldOfView>& view,
                              const Options& o, const SystemMaker& system) {
  const std::vector<Vec3> firsts = firstClicks(v, o.users, o.seed);
  std::vector<UserRow> rows(firsts.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> pool;
  for (int j = 0; j < o.jobs; ++j)
    pool.emplace_back([&] {
      for (std::size_t u = next++; u < firsts.size(); u = next++)
        rows[u] = oneUser(v, view, firsts[u], o, system);
    });
  pool.clear();
  return rows;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

//! Users of a grade, and what is told of them.
struct Total {
  std::vector<UserRow> rows;
  void print(const std::string& system, const std::string& grade, int clicks) const {
    std::printf("%-28s %-6s %3zu users", system.c_str(), grade.c_str(), rows.size());
    for (int k = 0; k < clicks; ++k) {
      std::vector<double> dice;
      for (const UserRow& r : rows) dice.push_back(r.dice[k]);
      const double good =
          static_cast<double>(std::count_if(dice.begin(), dice.end(), [](double d) { return d >= kGood; }));
      const double n = static_cast<double>(dice.size());
      std::printf("  %d: median %.3f mean %.3f >=.8 %.2f", k + 1, median(dice),
                  std::accumulate(dice.begin(), dice.end(), 0.0) / n, good / n);
    }
    const auto good =
        std::count_if(rows.begin(), rows.end(), [](const UserRow& r) { return r.best >= kGood; });
    std::printf("  best candidate >=.8 %.2f\n", static_cast<double>(good) / static_cast<double>(rows.size()));
  }
};

struct NamedSystem {
  std::string name;
  SystemMaker run;
};

//! The policy as it is, with what was set, or once with each threshold to vary 20 % lower and higher.
std::vector<NamedSystem> systemsOf(const Options& o) {
  ObjectPolicy base;
  for (const std::string& entry : o.policy) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos || !changePolicy(base, entry.substr(0, equals), [&](double) {
          return std::stod(entry.substr(equals + 1));
        }))
      throw CLI::ValidationError("--policy", entry + " is not NAME=VALUE of a threshold");
  }
  std::vector<NamedSystem> out{{"handlebody", handlebodyWith(base)}};
  for (const std::string& entry : o.vary) {
    const auto equals = entry.find('=');
    for (const double factor : {0.8, 1.2}) {
      ObjectPolicy changed = base;
      if (equals != std::string::npos) {
        if (factor > 1) continue;
        if (!changePolicy(changed, entry.substr(0, equals),
                          [&](double) { return std::stod(entry.substr(equals + 1)); }))
          throw CLI::ValidationError("--vary", entry + " is not a threshold");
        out.push_back({entry, handlebodyWith(changed)});
        continue;
      }
      if (!changePolicy(changed, entry, [&](double v) { return v * factor; }))
        throw CLI::ValidationError("--vary", entry + " is not a threshold");
      char label[60];
      std::snprintf(label, sizeof label, "%s x %.1f", entry.c_str(), factor);
      out.push_back({label, handlebodyWith(changed)});
    }
  }
  if (o.peers) {
    const auto peer = [](Mask (*segment)(const Volume&, const std::vector<UserClick>&)) {
      return [segment]() -> System {
        return [segment](const Volume& volume, const std::shared_ptr<const FieldOfView>&,
                         const std::vector<UserClick>& clicks, int) {
          return Answer{segment(volume, clicks), 0};
        };
      };
    };
    out.push_back({"confidence connected", peer(confidenceConnected)});
    out.push_back({"grow from seeds", peer(growFromSeeds)});
  }
  return out;
}

void run(const Options& o) {
  const std::vector<NamedSystem> systems = systemsOf(o);
  std::map<std::pair<std::size_t, std::string>, Total> totals;
  for (const LabelledCase& c : readCases(o.cases)) {
    if (!o.only.empty() && ("," + o.only + ",").find("," + c.name + ",") == std::string::npos) continue;
    const LabelledVolume v = readLabelled(c);
    const auto view = FieldOfView::find(v.volume);
    for (std::size_t s = 0; s < systems.size(); ++s) {
      const std::vector<UserRow> rows = allUsers(v, view, o, systems[s].run);
      for (const UserRow& r : rows) {
        totals[{s, c.grade}].rows.push_back(r);
        totals[{s, "all"}].rows.push_back(r);
        if (!o.each) continue;
        std::printf("%-24s %-24s", c.name.c_str(), systems[s].name.c_str());
        for (const double d : r.dice) std::printf(" %.3f", d);
        std::printf("  s");
        for (const double t : r.seconds) std::printf(" %.1f", t);
        std::printf("  expected %.2f\n", r.expected);
      }
      std::fflush(stdout);
    }
  }
  for (const auto& [key, total] : totals) total.print(systems[key.first].name, key.second, o.clicks);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A simulated user on labelled real volumes: Dice of the regions after each click."};
  Options o;
  app.add_option("cases", o.cases, "JSON list of volumes and labels")->required();
  app.add_option("--only", o.only, "names of cases, with commas between");
  app.add_option("--users", o.users, "users per structure");
  app.add_option("--clicks", o.clicks, "clicks of each");
  app.add_option("--best-of", o.bestOf, "candidates of which the best is told, too");
  app.add_option("--jobs", o.jobs, "users at once");
  app.add_option("--seed", o.seed, "of the first clicks");
  app.add_flag("--each", o.each, "a line for every user");
  app.add_flag("--peers", o.peers, "peers beside ours");
  app.add_option("--policy", o.policy, "NAME=VALUE of a threshold");
  app.add_option("--vary", o.vary, "NAME: 20 % lower and higher; NAME=VALUE: with that; beside the rest");
  CLI11_PARSE(app, argc, argv);
  try {
    run(o);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
