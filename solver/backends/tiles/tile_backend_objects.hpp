// TileBackend: kinematic objects.
#pragma once

namespace sandsim::tiles {

/// Copies the shapes to the machine.
template <class Machine, class Tile>
void TileBackend<Machine, Tile>::take_objects() {
  if (config_.objects.empty()) {
    return;
  }
  const auto copy = [&](auto& to, const auto* from, std::size_t count) {
    to = allocate<std::remove_cvref_t<decltype(*from)>>(count);
    machine_->upload(to.data(), from, count);
    return to.data();
  };
  for (const auto& object : config_.objects) {
    ShapeCopy shape;
    shape.view = object->shape();
    objects::ShapeView& view = shape.view;
    view.primitives = copy(shape.primitives, view.primitives, static_cast<std::size_t>(view.primitive_count));
    view.instructions = copy(shape.instructions, view.instructions, static_cast<std::size_t>(view.instruction_count));
    if (view.is_sampled()) {
      const auto points = static_cast<std::size_t>(view.grid.nx) * static_cast<std::size_t>(view.grid.ny) *
                          static_cast<std::size_t>(view.grid.nz);
      view.grid.values = copy(shape.grid, view.grid.values, points);
    }
    shapes_.push_back(std::move(shape));
  }
  coupling_sums_ = allocate<coupling::CouplingSums>(1);
}

/// The objects beside the one that is coupled, with their shapes on the machine.
template <class Machine, class Tile>
void TileBackend<Machine, Tile>::take_others(coupling::Job<R>& job, const ObjectStep& one,
                                             const std::vector<ObjectStep>& all) {
  job.cover = tile_.fields.cover;
  std::vector<coupling::Body> others = coupling::bodies_beside(config_, all, one.object, job.patch);
  for (coupling::Body& body : others) {
    body.shape = shapes_[body.object].view;
  }
  if (!others.empty()) {
    if (other_bodies_.size() < others.size()) {
      other_bodies_ = allocate<coupling::Body>(others.size());
    }
    machine_->upload(other_bodies_.data(), others.data(), others.size());
  }
  job.others = other_bodies_.data(), job.other_count = static_cast<int>(others.size());
}

template <class Machine, class Tile>
ObjectEffect TileBackend<Machine, Tile>::couple(const ObjectStep& one, const std::vector<ObjectStep>& all) {
  auto job = coupling::make_job<R>(config_, one);
  if (job.patch.empty()) {
    return {};
  }
  const auto patch_cells = static_cast<std::size_t>(job.patch.cells());
  if (coupling_levels_.size() < patch_cells) {
    coupling_levels_ = allocate<int>(patch_cells);
    coupling_scratch_ = allocate<double>(patch_cells * coupling::scratch_rows);
  }
  const Coupling coupling = config_.objects[one.object]->coupling();
  job.state = tile_.fields.state(control_.current);
  job.bed = tile_.fields.bed, job.flat = Tile::flat;
  job.body.shape = shapes_[one.object].view;
  if (config_.covers && coupling != Coupling::drag) {
    take_others(job, one, all);
  }
  job.scratch = coupling_scratch_.data(), job.levels = coupling_levels_.data(), job.sums = coupling_sums_.data();
  machine_->launch(CoupleKernel<Tile>{job, coupling}, {1, 1}, {CoupleKernel<Tile>::most_threads, 1}, block_sum_bytes);
  coupling::CouplingSums sums;
  machine_->download(&sums, coupling_sums_.data(), 1);
  if (sums.changed > 0.0) {
    control_.fastest = find_fastest();
  }
  return coupling::effect_of(sums, config_.grid.spacing);
}

}  // namespace sandsim::tiles
