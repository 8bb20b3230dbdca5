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

template <class Machine, class Tile>
ObjectEffect TileBackend<Machine, Tile>::couple(std::size_t k, const objects::RigidState& before,
                                                const objects::RigidState& after) {
  const objects::Object& object = *config_.objects[k];
  auto job = coupling::make_job<R>(config_.grid, object, before, after);
  if (job.patch.empty()) {
    return {};
  }
  const auto patch_cells = static_cast<std::size_t>(job.patch.cells());
  if (coupling_levels_.size() < patch_cells) {
    coupling_levels_ = allocate<int>(patch_cells);
    coupling_scratch_ = allocate<double>(patch_cells * coupling::scratch_rows);
  }
  job.state = tile_.fields.state(control_.current);
  job.bed = tile_.fields.bed, job.flat = Tile::flat;
  job.shape = shapes_[k].view;
  job.scratch = coupling_scratch_.data(), job.levels = coupling_levels_.data(), job.sums = coupling_sums_.data();
  machine_->upload(found_speed_.data(), &control_.fastest, 1);
  machine_->launch(CoupleKernel<Tile>{tile_, job, object.coupling(), found_speed_.data()}, {1, 1},
                   {CoupleKernel<Tile>::most_threads, 1}, block_sum_bytes);
  machine_->download(&control_.fastest, found_speed_.data(), 1);
  coupling::CouplingSums sums;
  machine_->download(&sums, coupling_sums_.data(), 1);
  return coupling::effect_of(sums, config_.grid.spacing);
}

}  // namespace sandsim::tiles
