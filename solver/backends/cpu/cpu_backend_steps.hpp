// CpuBackend: its steps, and what happens between them. Included by cpu_backend.hpp.
#pragma once

namespace sandsim::cpu {

template <class Rows, class Make>
void CpuBackend<Rows, Make>::take_speeds(const Rows& rows, std::size_t which, int j0, int j1) {
  for (int j = j0; j < j1; ++j) {
    row_speed_[static_cast<std::size_t>(j)] =
        rows.row_speed(h_[which].view(), hu_[which].view(), hv_[which].view(), j, 0, nx());
  }
}

template <class Rows, class Make>
double CpuBackend<Rows, Make>::stable_step() const {
  R fastest = 0;
  for (const R speed : row_speed_) {
    fastest = std::max(fastest, speed);
  }
  return fastest > R(0)
             ? static_cast<double>(Rows::step_courant(static_cast<R>(config_.courant)) * parameters(R(0)).dx / fastest)
             : std::numeric_limits<double>::infinity();
}

template <class Rows, class Make>
SpeedLimit CpuBackend<Rows, Make>::speed_limit() const {
  const Rows rows = make_(fields(), parameters(R(0)));
  SpeedLimit limit;
  for (int j = 0; j < ny(); ++j) {
    for (int i = 0; i < nx(); ++i) {
      const R speed = rows.row_speed(h_[current_].view(), hu_[current_].view(), hv_[current_].view(), j, i, i + 1);
      if (limit.i < 0 || static_cast<double>(speed) > limit.speed) {
        limit = {i, j, static_cast<double>(speed)};
      }
    }
  }
  return limit;
}

template <class Rows, class Make>
int CpuBackend<Rows, Make>::step_block(const Rows& rows, Scratch<R>& scratch, int block) {
  const int j0 = block * block_rows(), j1 = std::min(j0 + block_rows(), ny());
  int flags = 0;
  for (int i0 = 0; i0 < nx(); i0 += tile_) {
    flags |= rows.step({i0, std::min(i0 + tile_, nx()), j0, j1}, scratch, flow_);
  }
  for (int j = j0; j < j1; ++j) {
    halo_.fill_columns(h_[next()].view(), hu_[next()].view(), hv_[next()].view(), j);
  }
  // The block is still in cache: take the speeds of all rows whose neighbours it holds.
  const int edge = speed_needs_neighbours ? 1 : 0;
  take_speeds(rows, next(), j0 + edge, j1 - edge);
  return flags;
}

template <class Rows, class Make>
void CpuBackend<Rows, Make>::step_edges(const Rows& rows, int block) {
  const int first = block * block_rows(), last = std::min(first + block_rows(), ny()) - 1;
  take_speeds(rows, next(), first, first + 1);
  take_speeds(rows, next(), last, last + 1);
}

template <class Rows, class Make>
StepOutcome CpuBackend<Rows, Make>::step(double dt) {
  const Rows rows = make_(fields(), parameters(static_cast<R>(dt)));
  const auto start = team_.adapts() ? std::chrono::steady_clock::now() : std::chrono::steady_clock::time_point{};
  const int flags = team_.size() == 1 ? step_alone(rows) : step_together(rows);
  if (team_.adapts()) {
    team_.took(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  current_ = next();
  return {(flags & moving) != 0, (flags & changed) != 0, (flags & broken) != 0, outflow(dt)};
}

/// Without a parallel region, which costs more than the step of a small grid.
template <class Rows, class Make>
int CpuBackend<Rows, Make>::step_alone(const Rows& rows) {
  int flags = 0;
  for (int block = 0; block < blocks(); ++block) {
    flags |= step_block(rows, scratch_.front(), block);
  }
  fill_ghost_rows(next());
  for (int block = 0; speed_needs_neighbours && block < blocks(); ++block) {
    step_edges(rows, block);
  }
  return flags;
}

template <class Rows, class Make>
int CpuBackend<Rows, Make>::step_together(const Rows& rows) {
  int flags = 0;
#pragma omp parallel num_threads(team_.size()) reduction(| : flags)
  {
    Scratch<R>& scratch = scratch_[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int block = 0; block < blocks(); ++block) {
      flags |= step_block(rows, scratch, block);
    }
#pragma omp single
    fill_ghost_rows(next());
    if constexpr (speed_needs_neighbours) {
#pragma omp for schedule(static)
      for (int block = 0; block < blocks(); ++block) {
        step_edges(rows, block);
      }
    }
  }
  return flags;
}

template <class Rows, class Make>
double CpuBackend<Rows, Make>::outflow(double dt) const {
  double mass = 0.0;
  for (const std::vector<double>& side : side_mass_) {
    mass += sum_in_lanes<double>(side.size(), [&](double& lane, std::size_t k) { lane += side[k]; });
  }
  return mass * static_cast<double>(static_cast<R>(dt)) * config_.grid.spacing;
}

template <class Rows, class Make>
double CpuBackend<Rows, Make>::rain(const SandRain& rain, double dt) {
  const R growth = static_cast<R>(rain.rate * dt);
  int j_first = ny(), j_last = -1;
  const double gained = sum_in_lanes<double>(rain.cells.size(), [&](double& lane, std::size_t k) {
    const int j = static_cast<int>(rain.cells[k] / nx()), i = static_cast<int>(rain.cells[k] % nx());
    R& h = h_[current_].row(j)[i];
    const R before = h;
    h = h + growth;
    lane += static_cast<double>(h) - static_cast<double>(before);
    j_first = std::min(j_first, j), j_last = std::max(j_last, j);
  });
  refresh_rows(j_first, j_last + 1);
  return gained * config_.grid.spacing * config_.grid.spacing;
}

template <class Rows, class Make>
void CpuBackend<Rows, Make>::refresh_rows(int j0, int j1) {
  for (int j = j0; j < j1; ++j) {
    halo_.fill_columns(h_[current_].view(), hu_[current_].view(), hv_[current_].view(), j);
  }
  fill_ghost_rows(current_);
  const Rows rows = make_(fields(), parameters(R(0)));
  take_speeds(rows, current_, std::max(0, j0 - 1), std::min(ny(), j1 + 1));
  if (config_.boundaries.y_min == BoundaryKind::periodic && (j0 == 0 || j1 == ny())) {
    take_speeds(rows, current_, 0, 1);  // neighbours across the periodic sides
    take_speeds(rows, current_, ny() - 1, ny());
  }
}

template <class Rows, class Make>
ObjectEffect CpuBackend<Rows, Make>::couple(const ObjectStep& one, const std::vector<ObjectStep>& all) {
  auto job = coupling::make_job<R>(config_, one);
  if (job.patch.empty()) {
    return {};
  }
  const Coupling coupling = config_.objects[one.object]->coupling();
  job.state = {h_[current_].row(0), hu_[current_].row(0), hv_[current_].row(0), h_[current_].view().stride};
  job.bed = bed_.view(), job.flat = Rows::flat;
  std::vector<coupling::Body> others;
  if (config_.covers && coupling != Coupling::drag) {
    job.cover = {ground_.view(), buried_.view()};
    others = coupling::bodies_beside(config_, all, one.object, job.patch);
    job.others = others.data(), job.other_count = static_cast<int>(others.size());
  }
  const coupling::CouplingSums sums = coupling_scratch_.couple(job, coupling);
  if (sums.changed > 0.0) {
    refresh_rows(job.patch.j0, job.patch.j1);
  }
  return coupling::effect_of(sums, config_.grid.spacing);
}

template <class Rows, class Make>
void CpuBackend<Rows, Make>::move_particles(double dt) {
  const Diagnosed<R> d = diagnosed();
  const R dry = d.parameters.dry_depth;
#pragma omp parallel for num_threads(team_.size()) schedule(static) if (team_.size() > 1)
  for (int j = 0; j < ny(); ++j) {
    for (int i = 0; i < nx(); ++i) {
      const physics::Material<R> material =
          Rows::uniform ? material_ : physics::Material<R>{mu_.row(j)[i], alpha_.row(j)[i], cap_.row(j)[i]};
      particles_->sand().take(i, j, d.h.row(j)[i], d.hu.row(j)[i], d.hv.row(j)[i], d.b(i, j), d.cover, material, dry);
    }
  }
  particle_machine_->use(team_.room_for(particle_threads_));
  particles_->move(dt);
}

template <class Rows, class Make>
void CpuBackend<Rows, Make>::begin_capture(const CaptureRequest& request) {
  capture_ = {{}, sample(request.cells), {}, statistics()};
  if (particles_) {
    particles_->begin_capture();
    capture_.particles = particles_->end_capture();
  }
  for (const std::string& name : request.fields) {
    capture_.fields.push_back(field(name));
  }
}

template <class Rows, class Make>
std::vector<ProbeSample> CpuBackend<Rows, Make>::sample(const std::vector<std::int64_t>& cells) const {
  std::vector<ProbeSample> samples;
  for (const std::int64_t cell : cells) {
    samples.push_back(probe(diagnosed(), static_cast<int>(cell % nx()), static_cast<int>(cell / nx())));
  }
  return samples;
}

}  // namespace sandsim::cpu
