// Loops of the paper's scheme over the rows of a tile: velocities of the row ahead, faces, update.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "solver/backends/cpu/rows.hpp"
#include "solver/physics/paper_scheme.hpp"
#include "solver/physics/velocity.hpp"
#include "solver/physics/wave_speed.hpp"

namespace sandsim::cpu {

/// Chosen once a run. Flat: no bed is read. Uniform: no material maps. OneD: one row, no y axis.
template <class R, bool Flat, bool Uniform, bool OneD>
class PaperRows {
 public:
  using Real = R;
  static constexpr bool flat = Flat;
  static constexpr bool uniform = Uniform;
  static constexpr bool one_d = OneD;
  static constexpr bool speed_needs_neighbours = false;
  /// Factor of dx over the largest speed in the stable step: the Courant number is already in the speeds.
  static R step_courant(R) { return R(1); }
  static constexpr int scratch_rows = 2 * 2 + 3 * 3;

  PaperRows(const StepFields<R>& fields, const physics::StepParameters<R>& parameters,
            const physics::PaperSwitches<R>& switches, R courant)
      : f_(fields), p_(parameters), switches_(switches), courant_(courant) {}

  /// Steps a tile. Returns the flags of its cells; notes the mass through open sides in `flow`.
  int step(const Tile& t, Scratch<R>& scratch, const SideFlow& flow) const;

  /// Largest speed that bounds the step, over columns [i0, i1) of row j of the new state.
  R row_speed(const FieldView<R>& h, const FieldView<R>& hu, const FieldView<R>& hv, int j, int i0, int i1) const;

 private:
  struct VelocityRow {
    R *u, *v;
  };
  struct FluxRow {
    SANDSIM_HD physics::FaceFlux<R> at(std::ptrdiff_t i) const {
      return {mass[i], normal[i], transverse[i], R(0), R(0)};
    }
    R *mass, *normal, *transverse;
  };
  struct Side {
    const R *h, *n, *t;
  };

  void velocity_row(int j, int first, int last, const VelocityRow& out) const;
  /// Faces [first, last): face i lies between cell i - shift of `minus` and cell i of `plus`.
  void faces(const Side& minus, int shift, const Side& plus, int first, int last, const FluxRow& out) const;
  int update_row(int j, int first, int last, const VelocityRow& w, const FluxRow& along, const FluxRow& south,
                 const FluxRow& north) const;
  SANDSIM_HD static R velocity(R momentum, R h, const physics::StepParameters<R>& p, bool desingularised) {
    return desingularised ? physics::desingularised_velocity(momentum, h, p.dx)
                          : physics::quotient_velocity(momentum, h, p.dry_depth);
  }

  StepFields<R> f_;
  physics::StepParameters<R> p_;
  physics::PaperSwitches<R> switches_;
  R courant_;
};

template <class R, bool Flat, bool Uniform, bool OneD>
void PaperRows<R, Flat, Uniform, OneD>::velocity_row(int j, int first, int last, const VelocityRow& out) const {
  const R *h = f_.h.row(j), *hu = f_.hu.row(j), *hv = f_.hv.row(j);
  const VelocityRow w = out;
  const physics::StepParameters<R> p = p_;
  const auto fill = [=](auto desingularised) {
#pragma omp simd
    for (int i = first; i < last; ++i) {
      w.u[i] = velocity(hu[i], h[i], p, desingularised.value);
      w.v[i] = velocity(hv[i], h[i], p, desingularised.value);
    }
  };
  if (switches_.desingularised) {
    fill(std::true_type{});
  } else {
    fill(std::false_type{});
  }
}

template <class R, bool Flat, bool Uniform, bool OneD>
void PaperRows<R, Flat, Uniform, OneD>::faces(const Side& minus, int shift, const Side& plus, int first, int last,
                                              const FluxRow& out) const {
  const Side L = minus, Q = plus;
  const FluxRow o = out;
  const physics::PaperSwitches<R> switches = switches_;
  const R g = p_.g;
#pragma omp simd
  for (int i = first; i < last; ++i) {
    const auto F = physics::paper_flux<R>({L.h[i - shift], L.n[i - shift], L.t[i - shift]}, {Q.h[i], Q.n[i], Q.t[i]},
                                          switches, g);
    o.mass[i] = F.mass, o.normal[i] = F.normal, o.transverse[i] = F.transverse;
  }
}

template <class R, bool Flat, bool Uniform, bool OneD>
int PaperRows<R, Flat, Uniform, OneD>::update_row(int j, int first, int last, const VelocityRow& w,
                                                  const FluxRow& along, const FluxRow& south,
                                                  const FluxRow& north) const {
  const int js = OneD ? j : j - 1, jn = OneD ? j : j + 1;
  const R *h = f_.h.row(j), *h_s = f_.h.row(js), *h_n = f_.h.row(jn), *hu = f_.hu.row(j), *hv = f_.hv.row(j);
  const R *b = f_.bed.row(j), *b_s = f_.bed.row(js), *b_n = f_.bed.row(jn);
  R *h_new = f_.h_new.row(j), *hu_new = f_.hu_new.row(j), *hv_new = f_.hv_new.row(j);
  const R *mu = f_.mu.row(j), *alpha = f_.alpha.row(j), *cap = f_.cap.row(j);
  const VelocityRow velocities = w;
  const FluxRow x = along, lower = south, upper = north;
  const physics::StepParameters<R> p = p_;
  const physics::Material<R> material = f_.material;
  int flags = 0;
#pragma omp simd reduction(| : flags)
  for (int i = first; i < last; ++i) {
    R across_x = h[i + 1] - h[i - 1], across_y = OneD ? R(0) : h_n[i] - h_s[i];
    if constexpr (!Flat) {
      across_x = across_x + (b[i + 1] - b[i - 1]);
      across_y = OneD ? R(0) : across_y + (b_n[i] - b_s[i]);
    }
    physics::FaceFlux<R> below{}, above{};
    if constexpr (!OneD) {
      below = lower.at(i), above = upper.at(i);
    }
    const auto s = physics::paper_update<OneD>(h[i], velocities.u[i], velocities.v[i], across_x, across_y, x.at(i),
                                               x.at(i + 1), below, above,
                                               material_at<Uniform>(material, mu, alpha, cap, i), p);
    flags |= step_flags(h[i], hu[i], hv[i], s.h, s.hu, s.hv);
    h_new[i] = s.h, hu_new[i] = s.hu, hv_new[i] = s.hv;
  }
  return flags;
}

template <class R, bool Flat, bool Uniform, bool OneD>
int PaperRows<R, Flat, Uniform, OneD>::step(const Tile& t, Scratch<R>& scratch, const SideFlow& flow) const {
  int next = 0;
  const auto row = [&] { return scratch.row(next++, t.i0); };
  VelocityRow present{row(), row()}, ahead{row(), row()};
  FluxRow along{row(), row(), row()}, below{row(), row(), row()}, above{row(), row(), row()};
  const auto velocities = [&](int j, const VelocityRow& w) { velocity_row(j, t.i0 - 1, t.i1 + 1, w); };
  const auto sweep_x = [&](int j) {
    const Side side{f_.h.row(j), present.u, present.v};
    faces(side, 1, side, t.i0, t.i1 + 1, along);
    flow.note_columns(t, j, along.mass);
  };
  if constexpr (OneD) {
    velocities(t.j0, present);
    sweep_x(t.j0);
    return update_row(t.j0, t.i0, t.i1, present, along, below, above);
  } else {
    const auto sweep_y = [&](int j) {  // the faces between rows j - 1 and j
      faces({f_.h.row(j - 1), present.v, present.u}, 0, {f_.h.row(j), ahead.v, ahead.u}, t.i0, t.i1, above);
      flow.note_rows(t, j, above.mass);
    };
    velocities(t.j0 - 1, present);
    velocities(t.j0, ahead);
    sweep_y(t.j0);
    int flags = 0;
    for (int j = t.j0; j < t.j1; ++j) {
      std::swap(present, ahead);
      std::swap(below, above);
      velocities(j + 1, ahead);
      sweep_y(j + 1);
      sweep_x(j);
      flags |= update_row(j, t.i0, t.i1, present, along, below, above);
    }
    return flags;
  }
}

template <class R, bool Flat, bool Uniform, bool OneD>
R PaperRows<R, Flat, Uniform, OneD>::row_speed(const FieldView<R>& h_field, const FieldView<R>& hu_field,
                                               const FieldView<R>& hv_field, int j, int i0, int i1) const {
  const R *h = h_field.row(j), *hu = hu_field.row(j), *hv = hv_field.row(j);
  const physics::StepParameters<R> p = p_;
  const R courant = courant_;
  const auto largest = [=](auto desingularised) {
    R fastest = 0;
#pragma omp simd reduction(max : fastest)
    for (int i = i0; i < i1; ++i) {
      const R u = velocity(hu[i], h[i], p, desingularised.value);
      const R v = velocity(hv[i], h[i], p, desingularised.value);
      fastest = physics::maximum(fastest, physics::paper_speed<OneD>(h[i], u, v, p.g, courant));
    }
    return fastest;
  };
  return switches_.desingularised ? largest(std::true_type{}) : largest(std::false_type{});
}

}  // namespace sandsim::cpu
