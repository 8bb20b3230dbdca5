// TileBackend: its memory and its steps.
#pragma once

namespace sandsim::tiles {

template <class Machine, class Tile>
TileBackend<Machine, Tile>::TileBackend(const std::shared_ptr<Machine>& machine, const BackendConfig& config,
                                        const InitialState& initial, const Tile& tile)
    : machine_(machine),
      config_(config),
      halo_{config.grid.cells[0], config.grid.cells[1], config.boundaries},
      tile_(tile) {
  static_assert(std::is_trivially_copyable_v<Tile> && std::is_trivially_copyable_v<Control<R>>);
  check_memory(initial);
  TileFields<R>& f = tile_.fields;
  f.nx = nx(), f.ny = ny();
  f.sides = config.boundaries;
  f.spacing = config.grid.spacing;
  f.dx = static_cast<R>(config.grid.spacing);
  f.g = static_cast<R>(config.gravity);
  f.dry_depth = static_cast<R>(physics::dry_depth_fraction) * f.dx;
  tile_.courant = static_cast<R>(config.courant);
  lay_out_tiles();
  lay_out_states();
  take_material(initial);
  take_rains();
  take_objects();
  control_array_ = allocate<Control<R>>(1);
  row_sums_ = allocate<CellSums>(static_cast<std::size_t>(ny()) + 1);
  found_speed_ = allocate<R>(1);
  found_cell_ = allocate<std::int64_t>(1);
  captured_sums_ = HostArray<CellSums>(*machine_, 1);
  if (config.maxima) {
    maxima_array_ = allocate<R>(3 * cells());
    maxima_ = {maxima_array_.data(), maxima_array_.data() + cells(), maxima_array_.data() + 2 * cells(),
               static_cast<R>(config.above), static_cast<R>(config.drained)};
    const std::vector<R> none(cells(), R(0));
    set_maxima({none, none, std::vector<R>(cells(), std::numeric_limits<R>::quiet_NaN())});
  }
  if (config.particles) {
    particles_ =
        std::make_unique<particles::ParticleStage<Machine>>(machine, *config.particles, config.grid, config.boundaries);
  }
  const std::vector<R> depth(initial.depth.begin(), initial.depth.end()), still(depth.size(), R(0));
  set_state({depth, still, still});
}

template <class Machine, class Tile>
template <class T>
auto TileBackend<Machine, Tile>::allocate(std::size_t count) -> Array<T> {
  bytes_ += count * sizeof(T);
  return Array<T>(*machine_, count);
}

/// Strips as wide as pays for the columns that are only read, and so high that every processor has blocks to do.
template <class Machine, class Tile>
void TileBackend<Machine, Tile>::lay_out_tiles() {
  constexpr int warp = 32, widest = Tile::threads, most_rows = 64, fewest_rows = 4, blocks_a_processor = 8;
  const auto in_warps = [&](int threads) { return (threads + warp - 1) / warp * warp; };
  const int wanted = config_.tile_columns > 0 ? config_.tile_columns : nx();
  shape_ = {std::min(in_warps(wanted + 2 * Tile::reach), widest), 1};
  layout_.columns = std::min(wanted, shape_.width - 2 * Tile::reach);
  grid_.x = (nx() + layout_.columns - 1) / layout_.columns;
  const int rows = static_cast<int>(static_cast<std::int64_t>(ny()) * grid_.x /
                                    (static_cast<std::int64_t>(machine_->processors()) * blocks_a_processor));
  const int highest_grid = 65535;  // blocks along y that a device takes
  layout_.height = config_.block_rows > 0 ? config_.block_rows
                                          : std::max(std::clamp(rows, fewest_rows, most_rows), ny() / highest_grid + 1);
  layout_.height = std::min(layout_.height, ny());
  grid_.y = (ny() + layout_.height - 1) / layout_.height;
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::lay_out_states() {
  constexpr std::size_t line = 128 / sizeof(R);  // rows start where a device's memory reads start
  const std::size_t stride = (static_cast<std::size_t>(nx()) + line - 1) / line * line;
  const std::size_t field = stride * static_cast<std::size_t>(ny());
  states_ = allocate<R>(6 * field);
  for (int which = 0; which < 2; ++which) {
    R* first = states_.data() + static_cast<std::size_t>(3 * which) * field;
    tile_.fields.states[which] = {first, first + field, first + 2 * field, static_cast<std::ptrdiff_t>(stride)};
  }
  const Boundaries& sides = config_.boundaries;
  const auto faces = [](BoundaryKind kind, int count) {
    return kind == BoundaryKind::open ? static_cast<std::size_t>(count) : 0;
  };
  const std::size_t counts[4] = {faces(sides.x_min, ny()), faces(sides.x_max, ny()),
                                 Tile::one_d ? 0 : faces(sides.y_min, nx()),
                                 Tile::one_d ? 0 : faces(sides.y_max, nx())};
  side_mass_ = allocate<double>(counts[0] + counts[1] + counts[2] + counts[3]);
  double* next = side_mass_.data();
  double** const views[4] = {&tile_.fields.out.x_min, &tile_.fields.out.x_max, &tile_.fields.out.y_min,
                             &tile_.fields.out.y_max};
  for (int side = 0; side < 4; ++side) {
    *views[side] = counts[side] > 0 ? next : nullptr;
    next += counts[side];
  }
}

/// Before anything is allocated, for three fields that a frame may take too.
template <class Machine, class Tile>
void TileBackend<Machine, Tile>::check_memory(const InitialState& initial) const {
  const double needed = expected_bytes(config_, initial) + 3.0 * static_cast<double>(cells()) * sizeof(R);
  require_bytes(config_, needed, static_cast<double>(machine_->free_bytes()), machine_->name());
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::take_material(const InitialState& initial) {
  TileFields<R>& f = tile_.fields;
  if constexpr (!Tile::flat) {
    bed_ = stored_bed<R>(initial.bed, halo_, config_.covers);
    f.bed = upload_map(bed_, bed_copy_);
    if (config_.covers) {
      buried_ = allocate<double>(cells());
      const std::vector<double> none(cells(), 0.0);
      machine_->upload(buried_.data(), none.data(), none.size());
      f.cover = {upload_map(bed_, ground_copy_), {buried_.data(), nx()}};
    }
  }
  if constexpr (Tile::uniform) {
    f.material = {static_cast<R>(initial.friction_coefficient.front()), static_cast<R>(initial.hbar_scale.front()),
                  static_cast<R>(initial.hbar_cap.front())};
  } else {
    mu_ = stored_map<R>(initial.friction_coefficient, halo_);
    alpha_ = stored_map<R>(initial.hbar_scale, halo_);
    cap_ = stored_map<R>(initial.hbar_cap, halo_);
    f.mu = upload_map(mu_, mu_copy_), f.alpha = upload_map(alpha_, alpha_copy_), f.cap = upload_map(cap_, cap_copy_);
  }
}

template <class Machine, class Tile>
auto TileBackend<Machine, Tile>::upload_map(const Field<R>& host, Array<R>& copy) -> FieldView<R> {
  copy = allocate<R>(host.size());
  machine_->upload(copy.data(), host.data(), host.size());
  return {copy.data() + (host.view().origin - host.data()), host.view().stride};
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::take_rains() {
  if (config_.rains.empty()) {
    return;
  }
  std::vector<std::int64_t> cells;
  for (const SandRain& rain : config_.rains) {
    cells.insert(cells.end(), rain.cells.begin(), rain.cells.end());
  }
  rain_cells_ = allocate<std::int64_t>(cells.size());
  machine_->upload(rain_cells_.data(), cells.data(), cells.size());
  std::vector<RainView> views;
  const std::int64_t* next = rain_cells_.data();
  for (const SandRain& rain : config_.rains) {
    views.push_back({next, static_cast<std::int64_t>(rain.cells.size()), rain.rate, rain.start, rain.end});
    next += rain.cells.size();
  }
  rains_ = allocate<RainView>(views.size());
  machine_->upload(rains_.data(), views.data(), views.size());
}

template <class Machine, class Tile>
double TileBackend<Machine, Tile>::bytes_per_step() const {
  // The state in and out, and every map that is stored in full (a repeated row stays in cache).
  int words = 6;
  for (const Field<R>* field : {&bed_, &mu_, &alpha_, &cap_}) {
    words += field->view().stride > 0 ? 1 : 0;
  }
  return static_cast<double>(cells()) * words * static_cast<double>(sizeof(R));
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::launch_step(bool rain_follows) {
  machine_->launch(StepKernel<Tile>{tile_, layout_, control_array_.data(), rain_follows}, grid_, shape_,
                   step_shared_bytes<Tile>(shape_));
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::launch_maxima() {
  machine_->launch(MaximaKernel<Tile>{tile_, control_array_.data(), maxima_}, cell_blocks(), {cell_threads, 1}, 0);
}

template <class Machine, class Tile>
auto TileBackend<Machine, Tile>::control_for(const StepLoop& loop, const StepRules& rules, std::int64_t most) const
    -> Control<R> {
  Control<R> control = control_;
  control.loop = loop;
  control.rules = rules;
  control.remaining = most;
  control.go = loop.halt == Halt::none && most > 0 ? 1 : 0;
  return control;
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::advance(StepLoop& loop, const StepRules& rules, std::int64_t most,
                                         const LoopStages& stages, const std::function<void()>& meanwhile) {
  if (!config_.objects.empty()) {  // the host knows how they move
    meanwhile();
    advance_step_by_step(*this, config_, loop, rules, most, stages);
    return;
  }
  const std::int64_t before = loop.steps;
  control_ = control_for(loop, rules, most);
  const auto body = [this] {
    const bool rains = !config_.rains.empty();
    launch_step(rains);
    if (rains) {
      machine_->launch(
          RainKernel<Tile>{tile_, control_array_.data(), rains_.data(), static_cast<int>(config_.rains.size()), true},
          {1, 1}, {sum_lanes, 1}, block_sum_bytes);
      machine_->launch(EndRainKernel<Tile>{tile_, control_array_.data()}, cell_blocks(), {cell_threads, 1},
                       block_sum_bytes);
    }
    if (config_.maxima) {
      launch_maxima();
    }
  };
  {
    StageTimer timer(*stages.step, 0.0, 0);  // the seconds of the whole loop
    put_control();
    machine_->repeat(loop_, body, &control_array_.data()->go, meanwhile);
    get_control();
  }
  loop = control_.loop;
  const auto count = [&](StageReport* stage, double bytes) {
    if (stage != nullptr) {
      stage->launches += loop.steps - before;
      stage->bytes += bytes * static_cast<double>(loop.steps - before);
    }
  };
  count(stages.step, bytes_per_step());
  count(stages.sources, 0.0);
  count(stages.maxima, 1.5 * bytes_per_step());
}

template <class Machine, class Tile>
StepOutcome TileBackend<Machine, Tile>::step(double dt) {
  control_.loop = {};
  control_.loop.step = dt;
  control_.rules = {};
  control_.remaining = control_.go = 1;
  put_control();
  launch_step(false);
  get_control();
  return control_.outcome;
}

template <class Machine, class Tile>
double TileBackend<Machine, Tile>::rain(const SandRain& rain, double dt) {
  const Array<std::int64_t> cells(*machine_, rain.cells.size());
  machine_->upload(cells.data(), rain.cells.data(), rain.cells.size());
  const RainView view{cells.data(), static_cast<std::int64_t>(rain.cells.size()), rain.rate, 0.0, dt};
  const Array<RainView> views(*machine_, 1);
  machine_->upload(views.data(), &view, 1);
  control_.loop = {};
  control_.loop.step = dt;
  control_.go = 1;
  put_control();
  machine_->launch(RainKernel<Tile>{tile_, control_array_.data(), views.data(), 1, false}, {1, 1}, {sum_lanes, 1},
                   block_sum_bytes);
  get_control();
  control_.fastest = find_fastest();
  return control_.rained;
}

}  // namespace sandsim::tiles
