// The laws of solver/physics as they run on a CUDA device and on the host.
#include <cstdio>
#include <cstring>
#include <vector>

#include "solver/physics/balanced_update.hpp"
#include "solver/physics/paper_scheme.hpp"
#include "solver/physics/wave_speed.hpp"
#include "tests/cuda/physics_on_device.hpp"

namespace {

using namespace sandsim::physics;

void check(cudaError_t status, const char* what) {
  if (status != cudaSuccess) {
    std::fprintf(stderr, "%s: %s\n", what, cudaGetErrorString(status));
    std::exit(1);
  }
}

/// A step of one cell in a row of five with made-up neighbours across: every law is called once.
template <class R>
struct Sample {
  R h[5], u[5], v[5], b[5];
};
template <class R>
struct Result {
  State<R> balanced, paper;
  R speed;
};

template <class R>
SANDSIM_HD CellReconstruction<R> cell(const Sample<R>& s, int i, const Material<R>& m, const StepParameters<R>& p) {
  const Profile3<R> x{
      {s.h[i - 1], s.h[i], s.h[i + 1], s.b[i - 1], s.b[i], s.b[i + 1]}, s.u[i - 1], s.u[i + 1], s.v[i - 1], s.v[i + 1]};
  const Profile3<R> y{
      {s.h[i + 1], s.h[i], s.h[i - 1], s.b[i + 1], s.b[i], s.b[i - 1]}, s.u[i + 1], s.u[i - 1], s.v[i + 1], s.v[i - 1]};
  return reconstruct<2, false, false>(x, y, s.u[i], s.v[i], m, p);
}

template <class R>
SANDSIM_HD FaceSide<R> side(const Sample<R>& s, int i, const CellReconstruction<R>& c, R half, const Material<R>& m) {
  return {s.h[i], s.b[i], s.u[i] + half * c.x.su + c.du, s.v[i] + half * c.x.sv + c.dv, c.x.sh, c.x.ss, c.dh, c.demand,
          c.Kx,   m};
}

template <class R>
SANDSIM_HD Result<R> step(const Sample<R>& s) {
  const Material<R> m{R(0.6f), R(0.8f), R(0.5f)};
  const StepParameters<R> p = step_parameters(R(0.25f), R(9.8f), R(0.015625f), R(1e-9f));
  const CellReconstruction<R> west = cell(s, 1, m, p), own = cell(s, 2, m, p), east = cell(s, 3, m, p);
  const R half = R(0.5f);
  const FaceFlux<R> left = balanced_flux<false>(side(s, 1, west, half, m), side(s, 2, own, -half, m), p);
  const FaceFlux<R> right = balanced_flux<false>(side(s, 2, own, half, m), side(s, 3, east, -half, m), p);
  const CellCore<R> core{own.x.sh, own.x.ss, own.y.sh, own.y.ss, own.dh, own.G};
  Result<R> out;
  out.balanced = balanced_update<2, false>(State<R>{s.h[2], s.h[2] * s.u[2], s.h[2] * s.v[2]}, core, left, right, left,
                                           right, m, p);
  const PaperSwitches<R> switches{R(1), true};
  const PaperSide<R> a{s.h[1], s.u[1], s.v[1]}, b{s.h[2], s.u[2], s.v[2]}, c{s.h[3], s.u[3], s.v[3]};
  const FaceFlux<R> paper_left = paper_flux(a, b, switches, p.g), paper_right = paper_flux(b, c, switches, p.g);
  out.paper = paper_update<false>(s.h[2], s.u[2], s.v[2], s.h[3] - s.h[1], s.h[3] - s.h[1], paper_left, paper_right,
                                  paper_left, paper_right, m, p);
  out.speed = balanced_speed<false>(s.h[2], s.u[2], s.v[2], own.G, m, p.g, p.dx, p.dry_depth);
  return out;
}

template <class R>
__global__ void step_all(const Sample<R>* samples, Result<R>* results, int count) {
  const int k = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (k < count) {
    results[k] = step(samples[k]);
  }
}

/// Depths with dry cells among them, velocities with zeros, a rough bed; the same on every machine.
template <class R>
std::vector<Sample<R>> samples(int count) {
  unsigned state = 12345u;
  const auto next = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<R>(state >> 8) / R(16777216);
  };
  std::vector<Sample<R>> all(static_cast<std::size_t>(count));
  for (Sample<R>& s : all) {
    for (int i = 0; i < 5; ++i) {
      s.h[i] = next() < R(0.2f) ? R(0) : next();
      s.u[i] = next() < R(0.3f) || s.h[i] == R(0) ? R(0) : next() - R(0.5f);
      s.v[i] = next() < R(0.3f) || s.h[i] == R(0) ? R(0) : next() - R(0.5f);
      s.b[i] = next() < R(0.5f) ? R(0) : next();
    }
  }
  return all;
}

template <class R>
int compare(const char* precision) {
  constexpr int count = 1 << 16;
  const std::vector<Sample<R>> in = samples<R>(count);
  Sample<R>* device_in = nullptr;
  Result<R>* device_out = nullptr;
  check(cudaMalloc(&device_in, sizeof(Sample<R>) * count), "allocate the samples");
  check(cudaMalloc(&device_out, sizeof(Result<R>) * count), "allocate the results");
  check(cudaMemcpy(device_in, in.data(), sizeof(Sample<R>) * count, cudaMemcpyHostToDevice), "copy the samples");
  step_all<<<count / 256, 256>>>(device_in, device_out, count);
  check(cudaGetLastError(), "launch the laws");
  std::vector<Result<R>> out(count);
  check(cudaMemcpy(out.data(), device_out, sizeof(Result<R>) * count, cudaMemcpyDeviceToHost), "copy the results");
  check(cudaFree(device_in), "free the samples");
  check(cudaFree(device_out), "free the results");
  int different = 0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Result<R> host = step(in[k]);
    different += std::memcmp(&host, &out[k], sizeof(host)) != 0 ? 1 : 0;
  }
  std::printf("%s: %d of %d cells differ between host and device\n", precision, different, count);
  return different;
}

}  // namespace

namespace sandsim::test {

int count_cells_that_differ() {
  return compare<float>("float32") + compare<double>("float64");
}

}  // namespace sandsim::test
