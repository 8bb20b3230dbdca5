// TileBackend: what is asked of the state between steps.
#pragma once

namespace sandsim::tiles {

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::set_state(const StateArrays& state) {
  const StateView<R>& view = tile_.fields.state(control_.current);
  const auto put = [&](const FieldValues& values, R* to) {
    const auto& from = std::get<std::vector<R>>(values);
    std::vector<R> rows(static_cast<std::size_t>(view.stride) * static_cast<std::size_t>(ny()), R(0));
    for (int j = 0; j < ny(); ++j) {
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(j) * nx(), nx(), rows.begin() + view.at(0, j));
    }
    machine_->upload(to, rows.data(), rows.size());
  };
  put(state.depth, view.h);
  put(state.momentum_x, view.hu);
  put(state.momentum_y, view.hv);
  if (state.has_covers()) {
    put_bed(std::get<std::vector<R>>(state.bed));
    machine_->upload(buried_.data(), std::get<std::vector<double>>(state.buried).data(), cells());
  }
  control_.fastest = find_fastest();
}

/// The bed as the flow sees it, where objects cover sand.
template <class Machine, class Tile>
void TileBackend<Machine, Tile>::put_bed(const std::vector<R>& values) {
  Field<R> bed(nx(), ny(), R(0));
  for (int j = 0; j < ny(); ++j) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(j) * nx(), nx(), bed.row(j));
  }
  halo_.fill_covered_bed(bed.view(), bed_.view());
  machine_->upload(bed_copy_.data(), bed.data(), bed.size());
}

template <class Machine, class Tile>
StateArrays TileBackend<Machine, Tile>::state() const {
  StateArrays state{field("flowing_depth"), field("momentum_x"), field("momentum_y"), {}, {}};
  if (config_.covers) {
    state.bed = field("flow_bed");
    std::vector<double> buried(cells());
    machine_->download(buried.data(), buried_.data(), cells());
    state.buried = std::move(buried);
  }
  return state;
}

template <class Machine, class Tile>
auto TileBackend<Machine, Tile>::find_fastest() const -> R {
  R fastest = 0;
  machine_->upload(found_speed_.data(), &fastest, 1);
  machine_->launch(SpeedKernel<Tile>{tile_, control_.current, found_speed_.data()}, cell_blocks(), {cell_threads, 1},
                   0);
  machine_->download(&fastest, found_speed_.data(), 1);
  return fastest;
}

template <class Machine, class Tile>
SpeedLimit TileBackend<Machine, Tile>::speed_limit() const {
  const R fastest = find_fastest();
  std::int64_t cell = static_cast<std::int64_t>(cells());
  machine_->upload(found_cell_.data(), &cell, 1);
  machine_->launch(FindSpeedKernel<Tile>{tile_, control_.current, found_speed_.data(), found_cell_.data()},
                   cell_blocks(), {cell_threads, 1}, 0);
  machine_->download(&cell, found_cell_.data(), 1);
  return {static_cast<int>(cell % nx()), static_cast<int>(cell / nx()), static_cast<double>(fastest)};
}

template <class Machine, class Tile>
template <class Ask>
auto TileBackend<Machine, Tile>::inspect(const Ask& ask) const {
  StateArrays copy = state();
  const auto view = [&](FieldValues& values) { return FieldView<R>{std::get<std::vector<R>>(values).data(), nx()}; };
  const bool covers = copy.has_covers();
  const Cover<R> cover =
      covers ? Cover<R>{bed_.view(), {std::get<std::vector<double>>(copy.buried).data(), nx()}} : Cover<R>{};
  const TileFields<R>& f = tile_.fields;
  return ask(Diagnosed<R>{nx(), ny(), f.spacing, f.parameters(R(0)), view(copy.depth), view(copy.momentum_x),
                          view(copy.momentum_y), covers ? view(copy.bed) : bed_.view(), mu_.view(), f.material, cover,
                          Tile::flat, Tile::uniform});
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::launch_field(const std::string& name, R* values) const {
  machine_->launch(FieldKernel<Tile>{tile_, control_.current, cell_field(name), values}, cell_blocks(),
                   {cell_threads, 1}, 0);
}

template <class Machine, class Tile>
FieldValues TileBackend<Machine, Tile>::field(const std::string& name) const {
  const Array<R> copy(*machine_, cells());
  launch_field(name, copy.data());
  std::vector<R> values(cells());
  machine_->download(values.data(), copy.data(), values.size());
  return values;
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::launch_sums() const {
  machine_->launch(RowSumsKernel<Tile>{tile_, control_.current, static_cast<R>(config_.above), row_sums_.data()},
                   {ny(), 1}, {sum_lanes, 1}, block_sum_bytes);
  machine_->launch(TotalKernel{row_sums_.data(), ny(), row_sums_.data() + ny()}, {1, 1}, {sum_lanes, 1},
                   block_sum_bytes);
}

template <class Machine, class Tile>
GridStatistics TileBackend<Machine, Tile>::statistics() const {
  launch_sums();
  CellSums sums;
  machine_->download(&sums, row_sums_.data() + ny(), 1);
  return grid_statistics(sums, config_.grid.spacing);
}

template <class Machine, class Tile>
std::vector<ProbeSample> TileBackend<Machine, Tile>::sample(const std::vector<std::int64_t>& cells) const {
  std::vector<ProbeSample> samples;
  for (const std::int64_t cell : cells) {
    samples.push_back(
        inspect([&](const auto& d) { return probe(d, static_cast<int>(cell % d.nx), static_cast<int>(cell / d.nx)); }));
  }
  return samples;
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::move_particles(double dt) {
  machine_->launch(ParticleSandKernel<Tile>{tile_, control_.current, particles_->sand()}, cell_blocks(),
                   {cell_threads, 1}, 0);
  particles_->move(dt);
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::begin_capture(const CaptureRequest& request) {
  request_ = request;
  const std::size_t count = request.fields.size() * cells(), probes = request.cells.size();
  if (staging_.size() < count) {
    staging_ = allocate<R>(count);
    captured_ = HostArray<R>(*machine_, count);
  }
  if (probe_values_.size() < 3 * probes) {
    probe_cells_ = allocate<std::int64_t>(probes);
    probe_values_ = allocate<double>(3 * probes);
    captured_probes_ = HostArray<double>(*machine_, 3 * probes);
    machine_->upload(probe_cells_.data(), request.cells.data(), probes);
  }
  for (std::size_t k = 0; k < request.fields.size(); ++k) {
    launch_field(request.fields[k], staging_.data() + k * cells());
  }
  launch_sums();
  if (particles_) {
    particles_->begin_capture();
  }
  if (probes > 0) {
    const int blocks = static_cast<int>((probes + cell_threads - 1) / cell_threads);
    machine_->launch(ProbeKernel<Tile>{tile_, control_.current, probe_cells_.data(), static_cast<std::int64_t>(probes),
                                       probe_values_.data()},
                     {blocks, 1}, {cell_threads, 1}, 0);
    machine_->begin_copy(captured_probes_.data(), probe_values_.data(), 3 * probes);
  }
  machine_->begin_copy(captured_sums_.data(), row_sums_.data() + ny(), 1);
  machine_->begin_copy(captured_.data(), staging_.data(), count);
}

template <class Machine, class Tile>
Capture TileBackend<Machine, Tile>::end_capture() {
  machine_->finish_copies();
  Capture capture;
  for (std::size_t k = 0; k < request_.fields.size(); ++k) {
    const R* first = captured_.data() + k * cells();
    capture.fields.push_back(std::vector<R>(first, first + cells()));
  }
  for (std::size_t k = 0; k < request_.cells.size(); ++k) {
    const double* sample = captured_probes_.data() + 3 * k;
    capture.probes.push_back({sample[0], sample[1], sample[2]});
  }
  if (particles_) {
    capture.particles = particles_->end_capture();
  }
  capture.statistics = grid_statistics(*captured_sums_.data(), config_.grid.spacing);
  return capture;
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::update_maxima(double time) {
  control_.loop.time = time;
  put_control();
  launch_maxima();
}

template <class Machine, class Tile>
FinalFields TileBackend<Machine, Tile>::maxima() const {
  const auto get = [&](const R* from) {
    std::vector<R> values(cells());
    machine_->download(values.data(), from, values.size());
    return values;
  };
  return {get(maxima_.depth), get(maxima_.speed), get(maxima_.arrival)};
}

template <class Machine, class Tile>
void TileBackend<Machine, Tile>::set_maxima(const FinalFields& fields) {
  const auto put = [&](R* to, const FieldValues& values) {
    machine_->upload(to, std::get<std::vector<R>>(values).data(), cells());
  };
  put(maxima_.depth, fields.max_depth);
  put(maxima_.speed, fields.max_speed);
  put(maxima_.arrival, fields.arrival_time);
}

}  // namespace sandsim::tiles
