// Loops of the balanced scheme over the rows of a tile. A tile is swept from its first row to its last: reconstruct the
// row ahead, the faces between it and the present row, the faces along the present row, then update the present row.
// All temporaries are scratch rows that stay in cache; memory is read and written once. Loops go over packs of cells;
// the last pack of a row may reach past its end, into padding or into columns that the next tile writes after.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "solver/backends/cpu/rows.hpp"
#include "solver/physics/balanced_update.hpp"
#include "solver/physics/velocity.hpp"
#include "solver/physics/wave_speed.hpp"

namespace sandsim::cpu {

/// Chosen once a run. Flat: no bed is read. Uniform: no material maps. OneD: one row, no y axis.
template <class R, int Order, bool Flat, bool Uniform, bool OneD>
class BalancedRows {
 public:
  using Real = R;
  using V = Pack<R>;
  static constexpr int lanes = static_cast<int>(V::size());
  static constexpr bool flat = Flat;
  static constexpr bool uniform = Uniform;
  static constexpr bool one_d = OneD;
  static constexpr bool speed_needs_neighbours = true;
  /// Factor of dx over the largest speed in the stable step.
  static R step_courant(R courant) { return courant; }
  static constexpr int scratch_rows = 3 * 2 + 2 * 15 + 3 * 5;

  BalancedRows(const StepFields<R>& fields, const physics::StepParameters<R>& parameters)
      : f_(fields), p_(parameters) {}

  /// Steps a tile. Returns the flags of its cells; passes the fluxes of open sides through `flow`.
  int step(const Tile& t, Scratch<R>& scratch, const SideFlow& flow) const;

  /// Largest speed that bounds the step, over columns [i0, i1) of row j of the new state.
  R row_speed(const FieldView<R>& h, const FieldView<R>& hu, const FieldView<R>& hv, int j, int i0, int i1) const;

 private:
  struct VelocityRow {
    R *u, *v;
  };
  struct CellRow {
    R *sh_x, *ss_x, *su_x, *sv_x, *sh_y, *ss_y, *su_y, *sv_y, *G, *demand, *dh, *du, *dv, *Kx, *Ky;
  };
  /// A row of cells as faces of one axis see them: n is normal to the face, t along it.
  struct Side {
    const R *h, *b, *mu, *alpha, *cap, *n, *t, *sh, *ss, *sn, *st, *dh, *dn, *dt, *demand, *K;
    physics::Material<V> material;

    SANDSIM_HD physics::FaceSide<V> at(std::ptrdiff_t i, const V& half) const {
      physics::FaceSide<V> s{load(h, i), Flat ? V(0) : load(b, i),
                             load(n, i), load(t, i),
                             V(0),       load(ss, i),
                             V(0),       load(demand, i),
                             load(K, i), material_at<Uniform>(material, mu, alpha, cap, i)};
      if constexpr (Order == 2) {
        s.normal = s.normal + half * load(sn, i) + load(dn, i);
        s.transverse = s.transverse + half * load(st, i) + load(dt, i);
        s.sh = load(sh, i);
        s.dh = load(dh, i);
      }
      return s;
    }
  };
  struct FluxRow {
    SANDSIM_HD physics::FaceFlux<V> at(std::ptrdiff_t i) const {
      return {load(mass, i), load(normal, i), load(transverse, i), load(jump_left, i), load(jump_right, i)};
    }
    R *mass, *normal, *transverse, *jump_left, *jump_right;
  };
  struct Rows {
    std::array<VelocityRow, 3> velocity;  // rows j - 1, j, j + 1 of the row being reconstructed
    std::array<CellRow, 2> cell;          // present row, row ahead
    std::array<FluxRow, 2> south_north;   // faces below and above the present row
    FluxRow along;
  };

  static Rows lay_out(Scratch<R>& scratch, int i0);
  void velocity_row(int j, int first, int last, const VelocityRow& out) const;
  void reconstruct_row(int j, int first, int last, const std::array<VelocityRow, 3>& w, const CellRow& out) const;
  Side side_along(int j, const VelocityRow& w, const CellRow& c) const;
  Side side_between(int j, const VelocityRow& w, const CellRow& c) const;
  /// Faces [first, last): face i lies between cell i - shift of `minus` and cell i of `plus`.
  void faces(const Side& minus, int shift, const Side& plus, int first, int last, const FluxRow& out) const;
  int update_row(int j, int first, int last, const CellRow& c, const FluxRow& along, const FluxRow& south,
                 const FluxRow& north) const;

  StepFields<R> f_;
  physics::StepParameters<R> p_;
};

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
auto BalancedRows<R, Order, Flat, Uniform, OneD>::lay_out(Scratch<R>& scratch, int i0) -> Rows {
  int next = 0;
  const auto row = [&] { return scratch.row(next++, i0); };
  const auto flux = [&] {
    FluxRow r;
    r.mass = row(), r.normal = row(), r.transverse = row(), r.jump_left = row(), r.jump_right = row();
    return r;
  };
  Rows rows;
  for (VelocityRow& w : rows.velocity) {
    w.u = row(), w.v = row();
  }
  for (CellRow& c : rows.cell) {
    c.sh_x = row(), c.ss_x = row(), c.su_x = row(), c.sv_x = row();
    c.sh_y = row(), c.ss_y = row(), c.su_y = row(), c.sv_y = row();
    c.G = row(), c.demand = row(), c.dh = row(), c.du = row(), c.dv = row(), c.Kx = row(), c.Ky = row();
  }
  rows.south_north = {flux(), flux()};
  rows.along = flux();
  return rows;
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
void BalancedRows<R, Order, Flat, Uniform, OneD>::velocity_row(int j, int first, int last,
                                                               const VelocityRow& out) const {
  const R *h = f_.h.row(j), *hu = f_.hu.row(j), *hv = f_.hv.row(j);
  const VelocityRow w = out;
  const V dry = p_.dry_depth;
  for (int i = first; i < last; i += lanes) {
    const V depth = load(h, i);
    store(w.u, i, physics::quotient_velocity(load(hu, i), depth, dry));
    store(w.v, i, physics::quotient_velocity(load(hv, i), depth, dry));
  }
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
void BalancedRows<R, Order, Flat, Uniform, OneD>::reconstruct_row(int j, int first, int last,
                                                                  const std::array<VelocityRow, 3>& w,
                                                                  const CellRow& out) const {
  const int js = OneD ? j : j - 1, jn = OneD ? j : j + 1;
  const R *h = f_.h.row(j), *h_s = f_.h.row(js), *h_n = f_.h.row(jn);
  const R *b = f_.bed.row(j), *b_s = f_.bed.row(js), *b_n = f_.bed.row(jn);
  const R *mu = f_.mu.row(j), *alpha = f_.alpha.row(j), *cap = f_.cap.row(j);
  const R *u = w[1].u, *v = w[1].v, *u_s = w[0].u, *v_s = w[0].v, *u_n = w[2].u, *v_n = w[2].v;
  const CellRow c = out;
  const physics::StepParameters<V> p = broadcast(p_);
  const physics::Material<V> material = broadcast(f_.material);
  for (int i = first; i < last; i += lanes) {
    const V depth = load(h, i), zero = 0;
    physics::Profile3<V> x{{load(h, i - 1), depth, load(h, i + 1), zero, zero, zero},
                           load(u, i - 1),
                           load(u, i + 1),
                           load(v, i - 1),
                           load(v, i + 1)};
    physics::Profile3<V> y{
        {load(h_s, i), depth, load(h_n, i), zero, zero, zero}, load(u_s, i), load(u_n, i), load(v_s, i), load(v_n, i)};
    if constexpr (!Flat) {
      x.line.b_minus = load(b, i - 1), x.line.b = load(b, i), x.line.b_plus = load(b, i + 1);
      y.line.b_minus = load(b_s, i), y.line.b = x.line.b, y.line.b_plus = load(b_n, i);
    }
    const auto r = physics::reconstruct<Order, Flat, OneD>(x, y, load(u, i), load(v, i),
                                                           material_at<Uniform>(material, mu, alpha, cap, i), p);
    store(c.G, i, r.G);
    store(c.demand, i, r.demand);
    store(c.Kx, i, r.Kx);
    store(c.ss_x, i, r.x.ss);
    if constexpr (Order == 2) {
      store(c.sh_x, i, r.x.sh), store(c.su_x, i, r.x.su), store(c.sv_x, i, r.x.sv);
      store(c.dh, i, r.dh), store(c.du, i, r.du), store(c.dv, i, r.dv);
    }
    if constexpr (!OneD) {
      store(c.Ky, i, r.Ky);
      store(c.ss_y, i, r.y.ss);
      if constexpr (Order == 2) {
        store(c.sh_y, i, r.y.sh), store(c.su_y, i, r.y.su), store(c.sv_y, i, r.y.sv);
      }
    }
  }
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
auto BalancedRows<R, Order, Flat, Uniform, OneD>::side_along(int j, const VelocityRow& w, const CellRow& c) const
    -> Side {
  return {f_.h.row(j),
          f_.bed.row(j),
          f_.mu.row(j),
          f_.alpha.row(j),
          f_.cap.row(j),
          w.u,
          w.v,
          c.sh_x,
          c.ss_x,
          c.su_x,
          c.sv_x,
          c.dh,
          c.du,
          c.dv,
          c.demand,
          c.Kx,
          broadcast(f_.material)};
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
auto BalancedRows<R, Order, Flat, Uniform, OneD>::side_between(int j, const VelocityRow& w, const CellRow& c) const
    -> Side {
  return {f_.h.row(j),
          f_.bed.row(j),
          f_.mu.row(j),
          f_.alpha.row(j),
          f_.cap.row(j),
          w.v,
          w.u,
          c.sh_y,
          c.ss_y,
          c.sv_y,
          c.su_y,
          c.dh,
          c.dv,
          c.du,
          c.demand,
          c.Ky,
          broadcast(f_.material)};
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
void BalancedRows<R, Order, Flat, Uniform, OneD>::faces(const Side& minus, int shift, const Side& plus, int first,
                                                        int last, const FluxRow& out) const {
  const Side L = minus, Q = plus;
  const FluxRow o = out;
  const physics::StepParameters<V> p = broadcast(p_);
  for (int i = first; i < last; i += lanes) {
    const auto F = physics::balanced_flux<Flat>(L.at(i - shift, V(0.5f)), Q.at(i, V(-0.5f)), p);
    store(o.mass, i, F.mass), store(o.normal, i, F.normal), store(o.transverse, i, F.transverse);
    store(o.jump_left, i, F.jump_left), store(o.jump_right, i, F.jump_right);
  }
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
int BalancedRows<R, Order, Flat, Uniform, OneD>::update_row(int j, int first, int last, const CellRow& cells,
                                                            const FluxRow& along, const FluxRow& south,
                                                            const FluxRow& north) const {
  const R *h = f_.h.row(j), *hu = f_.hu.row(j), *hv = f_.hv.row(j);
  R *h_new = f_.h_new.row(j), *hu_new = f_.hu_new.row(j), *hv_new = f_.hv_new.row(j);
  const R *mu = f_.mu.row(j), *alpha = f_.alpha.row(j), *cap = f_.cap.row(j);
  const CellRow c = cells;
  const FluxRow x = along, lower = south, upper = north;
  const physics::StepParameters<V> p = broadcast(p_);
  const physics::Material<V> material = broadcast(f_.material);
  StepWatch<R> watch;
  for (int i = first; i < last; i += lanes) {
    const V zero = 0;
    physics::CellCore<V> core{zero, load(c.ss_x, i), zero, zero, zero, load(c.G, i)};
    if constexpr (Order == 2) {
      core.sh_x = load(c.sh_x, i);
      core.dh = load(c.dh, i);
    }
    physics::FaceFlux<V> below{}, above{};
    if constexpr (!OneD) {
      core.ss_y = load(c.ss_y, i);
      if constexpr (Order == 2) {
        core.sh_y = load(c.sh_y, i);
      }
      below = lower.at(i), above = upper.at(i);
    }
    const physics::State<V> old{load(h, i), load(hu, i), load(hv, i)};
    const auto s = physics::balanced_update<Order, OneD>(old, core, x.at(i), x.at(i + 1), below, above,
                                                         material_at<Uniform>(material, mu, alpha, cap, i), p);
    watch.see(first_lanes<R>(last - i), old.h, old.hu, old.hv, s.h, s.hu, s.hv);
    store(h_new, i, s.h), store(hu_new, i, s.hu), store(hv_new, i, s.hv);
  }
  return watch.flags();
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
int BalancedRows<R, Order, Flat, Uniform, OneD>::step(const Tile& t, Scratch<R>& scratch, const SideFlow& flow) const {
  Rows rows = lay_out(scratch, t.i0);
  VelocityRow &before = rows.velocity[0], &present = rows.velocity[1], &ahead = rows.velocity[2];
  CellRow &cell = rows.cell[0], &cell_ahead = rows.cell[1];
  FluxRow &below = rows.south_north[0], &above = rows.south_north[1];
  const auto velocity = [&](int j, const VelocityRow& out) { velocity_row(j, t.i0 - 2, t.i1 + 2, out); };
  // Reconstructs row j into `cell_ahead` and moves the window of velocities so that `present` is row j.
  const auto advance = [&](int j) {
    std::swap(cell, cell_ahead);
    std::rotate(rows.velocity.begin(), rows.velocity.begin() + 1, rows.velocity.end());
    velocity(j + 1, ahead);
    reconstruct_row(j, t.i0 - 1, t.i1 + 1, rows.velocity, cell_ahead);
  };
  const auto along = [&](int j, const VelocityRow& w) {
    const Side side = side_along(j, w, cell);
    faces(side, 1, side, t.i0, t.i1 + 1, rows.along);
    flow.pass_columns(t, j, rows.along);
  };
  if constexpr (OneD) {
    velocity(t.j0, present);
    reconstruct_row(t.j0, t.i0 - 1, t.i1 + 1, {present, present, present}, cell);
    along(t.j0, present);
    return update_row(t.j0, t.i0, t.i1, cell, rows.along, below, above);
  } else {
    const auto between = [&](int j) {  // the faces between rows j - 1 and j
      faces(side_between(j - 1, before, cell), 0, side_between(j, present, cell_ahead), t.i0, t.i1, above);
      flow.pass_rows(t, j, above);
    };
    velocity(t.j0 - 2, present);
    velocity(t.j0 - 1, ahead);
    advance(t.j0 - 1);
    advance(t.j0);
    between(t.j0);
    int flags = 0;
    for (int j = t.j0; j < t.j1; ++j) {
      std::swap(below, above);
      advance(j + 1);
      between(j + 1);
      along(j, before);
      flags |= update_row(j, t.i0, t.i1, cell, rows.along, below, above);
    }
    return flags;
  }
}

template <class R, int Order, bool Flat, bool Uniform, bool OneD>
R BalancedRows<R, Order, Flat, Uniform, OneD>::row_speed(const FieldView<R>& h_field, const FieldView<R>& hu_field,
                                                         const FieldView<R>& hv_field, int j, int i0, int i1) const {
  const int js = OneD ? j : j - 1, jn = OneD ? j : j + 1;
  const R *h = h_field.row(j), *h_s = h_field.row(js), *h_n = h_field.row(jn);
  const R *hu = hu_field.row(j), *hv = hv_field.row(j);
  const R *b = f_.bed.row(j), *b_s = f_.bed.row(js), *b_n = f_.bed.row(jn);
  const R *mu = f_.mu.row(j), *alpha = f_.alpha.row(j), *cap = f_.cap.row(j);
  const physics::StepParameters<V> p = broadcast(p_);
  const physics::Material<V> material = broadcast(f_.material);
  V fastest = 0;
  for (int i = i0; i < i1; i += lanes) {
    const V depth = load(h, i), zero = 0;
    physics::Line<V> x{load(h, i - 1), depth, load(h, i + 1), zero, zero, zero};
    physics::Line<V> y{load(h_s, i), depth, load(h_n, i), zero, zero, zero};
    if constexpr (!Flat) {
      x.b_minus = load(b, i - 1), x.b = load(b, i), x.b_plus = load(b, i + 1);
      y.b_minus = load(b_s, i), y.b = x.b, y.b_plus = load(b_n, i);
    }
    const V slope_x = physics::compact_slope(physics::differences<Flat>(x), p.inverse_dx);
    V slope = physics::absolute(slope_x);
    if constexpr (!OneD) {
      slope = physics::length(slope_x, physics::compact_slope(physics::differences<Flat>(y), p.inverse_dx));
    }
    const V u = physics::quotient_velocity(load(hu, i), depth, p.dry_depth);
    const V v = physics::quotient_velocity(load(hv, i), depth, p.dry_depth);
    const V speed = physics::balanced_speed<OneD>(depth, u, v, slope, material_at<Uniform>(material, mu, alpha, cap, i),
                                                  p.g, p.dx, p.dry_depth);
    fastest = physics::maximum(fastest, physics::select(first_lanes<R>(i1 - i), speed, zero));
  }
  return hmax(fastest);
}

}  // namespace sandsim::cpu
