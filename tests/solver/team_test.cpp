#include "solver/backends/cpu/team.hpp"

#include <cmath>

#include "tests/support/catch.hpp"

using sandsim::cpu::Team;

namespace {

int only_this() {
  return 1;
}
int with_three_others() {
  return 4;
}
int unknown() {
  return 0;
}

/// Takes steps for `seconds` of their own time; a step takes so long with one thread and with the team. Returns the
/// time over that of one thread.
double take_steps(Team& team, double seconds, double alone, double together) {
  double spent = 0.0;
  int steps = 0;
  while (spent < seconds) {
    const double step = team.size() == 1 ? alone : together;
    team.took(step);
    spent += step, ++steps;
  }
  return spent / (steps * alone);
}

}  // namespace

TEST_CASE("A team that was asked for takes every step") {
  const Team team(2, false, 2, with_three_others);
  CHECK_FALSE(team.adapts());
  CHECK(team.size() == 2);
  CHECK(team.usual() == 2);
}

TEST_CASE("On an idle machine a team takes nearly all steps where it is faster") {
  Team team(2, true, 2, only_this);
  // Half of the time, but for the first window and trials of a fortieth.
  CHECK(take_steps(team, 1.0, 1e-3, 0.5e-3) < 0.55);
  CHECK(team.usual() == 2);
}

TEST_CASE("A team that is slower takes hardly any") {
  for (const auto running : {only_this, unknown}) {
    Team team(2, true, 2, running);
    // Trials end with their first step, after pauses of 40 times their length.
    CHECK(take_steps(team, 2.0, 0.5e-3, 20e-3) < 1.1);
    CHECK(team.usual() == 1);
  }
}

TEST_CASE("Without a processor for each thread no team is tried") {
  Team team(2, true, 2, with_three_others);
  CHECK(std::fabs(take_steps(team, 1.0, 1e-3, 0.5e-3) - 1.0) < 1e-9);  // the rounding of a thousand sums
  CHECK(team.usual() == 1);
}

TEST_CASE("A team that becomes slow is given up within some windows") {
  Team team(2, true, 2, only_this);
  take_steps(team, 0.5, 1e-3, 0.5e-3);
  CHECK(take_steps(team, 1.0, 1e-3, 5e-3) < 1.2);
}

TEST_CASE("Long steps are not spent on trials") {
  Team team(4, true, 4, only_this);
  // 50 steps of which the first and few others take one thread.
  CHECK(take_steps(team, 2.5, 0.16, 0.04) < 0.45);
}

TEST_CASE("A team has the processors that others leave") {
  static const Team* own = nullptr;
  Team team(16, true, 16, [] { return own->size() + 3; });
  own = &team;
  CHECK(team.room_for(16) == 13);
  CHECK(team.room_for(8) == 8);
  // A thirteenth of the time, but for the first window and some trials.
  CHECK(take_steps(team, 1.0, 1.3e-3, 0.1e-3) < 0.12);
  CHECK(team.usual() == 13);
}

TEST_CASE("Work on a small grid beside the steps takes the processors that are free") {
  CHECK(Team(1, true, 2, only_this).room_for(2) == 2);
  CHECK(Team(1, true, 2, with_three_others).room_for(2) == 1);
  CHECK(Team(1, false, 2, with_three_others).room_for(2) == 2);  // so many were asked for
}

TEST_CASE("A team that was slow for a moment is taken again soon") {
  Team team(2, true, 2, only_this);
  take_steps(team, 5.0, 1e-3, 0.5e-3);
  for (int second = 0; second < 10; ++second) {
    take_steps(team, 0.02, 1e-3, 10e-3);
    // A tenth of a second with one thread, and then half of the time.
    CHECK(take_steps(team, 1.0, 1e-3, 0.5e-3) < 0.65);
  }
}

TEST_CASE("Steps that become longer do not make a team give way") {
  Team team(2, true, 2, only_this);
  take_steps(team, 1.0, 1e-3, 0.5e-3);
  CHECK(take_steps(team, 1.0, 3e-3, 1.5e-3) < 0.55);
}
