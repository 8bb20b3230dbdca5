#include "io/scene/quantity.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>

#include "tests/support/catch.hpp"

using namespace sandsim;

namespace {

double value(const std::string& text, Dimension dimension, double cell = 0.0) {
  return std::get<double>(parse_quantity(text, dimension, cell, example(dimension)));
}

bool rejected(const std::string& text, Dimension dimension) {
  return std::holds_alternative<Complaint>(parse_quantity(text, dimension, 1.0, example(dimension)));
}

}  // namespace

TEST_CASE("every unit converts to SI") {
  CHECK(value("3 m", Dimension::length) == 3.0);
  CHECK(value("3 cm", Dimension::length) == 0.03);
  CHECK(value("3 mm", Dimension::length) == 0.003);
  CHECK(value("3 km", Dimension::length) == 3000.0);
  CHECK(value("3 cells", Dimension::length, 0.5) == 1.5);
  CHECK(value("2 rad", Dimension::angle) == 2.0);
  CHECK(value("180 deg", Dimension::angle) == std::numbers::pi);
  CHECK(value("2 s", Dimension::time) == 2.0);
  CHECK(value("2 ms", Dimension::time) == 0.002);
  CHECK(value("2 min", Dimension::time) == 120.0);
  CHECK(value("2 h", Dimension::time) == 7200.0);
  CHECK(value("3 m/s", Dimension::speed) == 3.0);
  CHECK(value("3 cm/s", Dimension::speed) == 0.03);
  CHECK(value("3 mm/s", Dimension::speed) == 0.003);
  CHECK(value("36 km/h", Dimension::speed) == 10.0);
  CHECK(value("3 rad/s", Dimension::angular_velocity) == 3.0);
  CHECK(value("180 deg/s", Dimension::angular_velocity) == std::numbers::pi);
  CHECK(value("1 rpm", Dimension::angular_velocity) == std::numbers::pi / 30);
  CHECK(value("9.81 m/s^2", Dimension::acceleration) == 9.81);
  CHECK(value("981 cm/s^2", Dimension::acceleration) == 9.81);
  CHECK(value("2 m^3/s", Dimension::volume_rate) == 2.0);
  CHECK(value("2 l/s", Dimension::volume_rate) == 0.002);
  CHECK(value("2 cm^3/s", Dimension::volume_rate) == 0.000002);
  CHECK(value("1500 kg/m^3", Dimension::density) == 1500.0);
  CHECK(value("1.5 g/cm^3", Dimension::density) == 1500.0);
  CHECK(value("1.5 t/m^3", Dimension::density) == 1500.0);
}

TEST_CASE("a decimal length in centimetres is the double nearest to it in metres") {
  // Multiplying by 0.01 would give 0.07000000000000001.
  CHECK(value("7 cm", Dimension::length) == 0.07);
  for (int k = 1; k < 1000; ++k) {
    CHECK(value(std::to_string(k) + " mm", Dimension::length) == k / 1000.0);
  }
}

TEST_CASE("numbers have all usual decimal forms") {
  CHECK(value("+1.5e-1 m", Dimension::length) == 0.15);
  CHECK(value("-1.5E+1m", Dimension::length) == -15.0);
  CHECK(value(".5 m", Dimension::length) == 0.5);
  CHECK(value("5.  m", Dimension::length) == 5.0);
  CHECK(value("0.25", Dimension::none) == 0.25);
  CHECK(value("1e-3", Dimension::none) == 0.001);
}

TEST_CASE("what is no plain decimal number is rejected") {
  for (const char* text :
       {"",      " ",     "m",     ". m",      "+ m",   "- 5 m",    "05 m",    "-05 m",    "0x5 m",  "1_000 m",
        "1,5 m", "nan m", ".nan",  "inf",      "-.inf", "Infinity", "1e999 m", "5 m 3 cm", "5 mm^2", "5 M",
        "5 m;",  "--5 m", "5 \tm", "1e308 km", "5",     "5 kg",     "5 deg",   "5 e"}) {
    CAPTURE(text);
    CHECK(rejected(text, Dimension::length));
  }
}

TEST_CASE("counts are whole numbers written with digits") {
  CHECK(std::get<int>(parse_count("160")) == 160);
  CHECK(std::get<int>(parse_count("-3")) == -3);
  for (const char* text : {"1.0", "1e3", "2147483648", "007", "0b1", "", "1 "}) {
    CAPTURE(text);
    CHECK((std::holds_alternative<Complaint>(parse_count(text)) || std::string(text) == "1 "));
  }
}

TEST_CASE("written quantities read back to the same bits") {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    const double number = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(number)) continue;
    const std::string text = quantity_text(number, Dimension::length);
    CAPTURE(text);
    CHECK(std::bit_cast<std::uint64_t>(value(text, Dimension::length)) == std::bit_cast<std::uint64_t>(number));
  }
  CHECK(std::signbit(value(quantity_text(-0.0, Dimension::time), Dimension::time)));
}
