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
  using V = Pack<R>;
  static constexpr int lanes = static_cast<int>(V::size());
  static constexpr bool flat = Flat;
  static constexpr bool uniform = Uniform;
  static constexpr bool one_d = OneD;
  static constexpr bool speed_needs_neighbours = false;
  /// Factor of dx over the largest speed in the stable step: the Courant number is already in the speeds.
  static R step_courant(R) { return R(1); }
  static constexpr int scratch_rows = 2 * 2 + 3 * 3;

  PaperRows(const StepFields<R>& fields, const physics::StepParameters<R>& parameters,
            const physics::PaperSwitches<V>& switches, bool desingularised, R courant)
      : f_(fields), p_(parameters), switches_(switches), desingularised_(desingularised), courant_(courant) {}

  /// Steps a tile. Returns the flags of its cells; passes the fluxes of open sides through `flow`.
  int step(const Tile& t, Scratch<R>& scratch, const SideFlow& flow) const;

  /// Largest speed that bounds the step, over columns [i0, i1) of row j of the new state.
  R row_speed(const FieldView<R>& h, const FieldView<R>& hu, const FieldView<R>& hv, int j, int i0, int i1) const;

 private:
  struct VelocityRow {
    R *u, *v;
  };
  struct FluxRow {
    SANDSIM_HD physics::FaceFlux<V> at(std::ptrdiff_t i) const {
      return {load(mass, i), load(normal, i), load(transverse, i), V(0), V(0)};
    }
    R *mass, *normal, *transverse;
  };
  struct Side {
    const R *h, *n, *t;

    SANDSIM_HD physics::PaperSide<V> at(std::ptrdiff_t i) const { return {load(h, i), load(n, i), load(t, i)}; }
  };

  void velocity_row(int j, int first, int last, const VelocityRow& out) const;
  /// Faces [first, last): face i lies between cell i - shift of `minus` and cell i of `plus`.
  void faces(const Side& minus, int shift, const Side& plus, int first, int last, const FluxRow& out) const;
  int update_row(int j, int first, int last, const VelocityRow& w, const FluxRow& along, const FluxRow& south,
                 const FluxRow& north) const;
  SANDSIM_HD static V velocity(const V& momentum, const V& h, const physics::StepParameters<V>& p,
                               bool desingularised) {
    return desingularised ? physics::desingularised_velocity(momentum, h, p.inverse_dx)
                          : physics::quotient_velocity(momentum, h, p.dry_depth);
  }

  StepFields<R> f_;
  physics::StepParameters<R> p_;
  physics::PaperSwitches<V> switches_;
  bool desingularised_;  // eq. 13, else hu/h
  R courant_;
};

template <class R, bool Flat, bool Uniform, bool OneD>
void PaperRows<R, Flat, Uniform, OneD>::velocity_row(int j, int first, int last, const VelocityRow& out) const {
  const R *h = f_.h.row(j), *hu = f_.hu.row(j), *hv = f_.hv.row(j);
  const VelocityRow w = out;
  const physics::StepParameters<V> p = broadcast(p_);
  const auto fill = [=](auto desingularised) {
    for (int i = first; i < last; i += lanes) {
      const V depth = load(h, i);
      store(w.u, i, velocity(load(hu, i), depth, p, desingularised.value));
      store(w.v, i, velocity(load(hv, i), depth, p, desingularised.value));
    }
  };
  if (desingularised_) {
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
  const physics::PaperSwitches<V> switches = switches_;
  const V g = p_.g;
  for (int i = first; i < last; i += lanes) {
    const auto F = physics::paper_flux(L.at(i - shift), Q.at(i), switches, g);
    store(o.mass, i, F.mass), store(o.normal, i, F.normal), store(o.transverse, i, F.transverse);
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
  const physics::StepParameters<V> p = broadcast(p_);
  const physics::Material<V> material = broadcast(f_.material);
  StepWatch<R> watch;
  for (int i = first; i < last; i += lanes) {
    V across_x = load(h, i + 1) - load(h, i - 1), across_y = OneD ? V(0) : load(h_n, i) - load(h_s, i);
    if constexpr (!Flat) {
      across_x = across_x + (load(b, i + 1) - load(b, i - 1));
      across_y = OneD ? V(0) : across_y + (load(b_n, i) - load(b_s, i));
    }
    physics::FaceFlux<V> below{}, above{};
    if constexpr (!OneD) {
      below = lower.at(i), above = upper.at(i);
    }
    const V depth = load(h, i);
    const auto s =
        physics::paper_update<OneD>(depth, load(velocities.u, i), load(velocities.v, i), across_x, across_y, x.at(i),
                                    x.at(i + 1), below, above, material_at<Uniform>(material, mu, alpha, cap, i), p);
    watch.see(first_lanes<R>(last - i), depth, load(hu, i), load(hv, i), s.h, s.hu, s.hv);
    store(h_new, i, s.h), store(hu_new, i, s.hu), store(hv_new, i, s.hv);
  }
  return watch.flags();
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
    flow.pass_columns(t, j, along);
  };
  if constexpr (OneD) {
    velocities(t.j0, present);
    sweep_x(t.j0);
    return update_row(t.j0, t.i0, t.i1, present, along, below, above);
  } else {
    const auto sweep_y = [&](int j) {  // the faces between rows j - 1 and j
      faces({f_.h.row(j - 1), present.v, present.u}, 0, {f_.h.row(j), ahead.v, ahead.u}, t.i0, t.i1, above);
      flow.pass_rows(t, j, above);
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
  const physics::StepParameters<V> p = broadcast(p_);
  const V courant = courant_;
  const auto largest = [=](auto desingularised) {
    V fastest = 0;
    for (int i = i0; i < i1; i += lanes) {
      const V depth = load(h, i), zero = 0;
      const V u = velocity(load(hu, i), depth, p, desingularised.value);
      const V v = velocity(load(hv, i), depth, p, desingularised.value);
      const V speed = physics::paper_speed<OneD>(depth, u, v, p.g, courant);
      fastest = physics::maximum(fastest, physics::select(first_lanes<R>(i1 - i), speed, zero));
    }
    return hmax(fastest);
  };
  return desingularised_ ? largest(std::true_type{}) : largest(std::false_type{});
}

}  // namespace sandsim::cpu
