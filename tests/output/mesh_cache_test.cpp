#include "io/output/mesh_cache.hpp"

#include <memory>
#include <variant>

#include "solver/errors.hpp"
#include "tests/output/fixtures.hpp"
#include "tests/support/catch.hpp"

using namespace sandsim;
using sandsim::objects::TriangleMesh;

namespace {

TriangleMesh tetrahedron(double height) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, height}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

}  // namespace

TEST_CASE("a baked mesh is taken from the cache the second time with the same bits") {
  const test::TemporaryDirectory folder;
  const CachedMesh first = bake_with_cache(tetrahedron(1), 32, folder.path());
  const CachedMesh second = bake_with_cache(tetrahedron(1), 32, folder.path(), [](double) { FAIL("it was baked"); });
  CHECK_FALSE(first.is_from_cache);
  CHECK(second.is_from_cache);
  CHECK(second.file == first.file);
  CHECK(second.baked.grid.values == first.baked.grid.values);
  CHECK(second.baked.grid.points == first.baked.grid.points);
  CHECK(second.baked.grid.spacing == first.baked.grid.spacing);
  CHECK(second.baked.grid.origin.z == first.baked.grid.origin.z);
  CHECK(second.baked.defects.is_closed());
}

TEST_CASE("defects of a mesh are kept in the cache") {
  const test::TemporaryDirectory folder;
  TriangleMesh open = tetrahedron(1);
  open.triangles.pop_back();
  bake_with_cache(open, 32, folder.path());
  const CachedMesh cached = bake_with_cache(open, 32, folder.path());
  CHECK(cached.is_from_cache);
  CHECK(cached.baked.defects.open_edges == 3);
}

TEST_CASE("another mesh or resolution is baked anew") {
  const test::TemporaryDirectory folder;
  bake_with_cache(tetrahedron(1), 32, folder.path());
  CHECK_FALSE(bake_with_cache(tetrahedron(2), 32, folder.path()).is_from_cache);
  CHECK_FALSE(bake_with_cache(tetrahedron(1), 33, folder.path()).is_from_cache);
  CHECK(bake_with_cache(tetrahedron(1), 32, folder.path()).is_from_cache);
}

TEST_CASE("a damaged file in the cache is replaced") {
  const test::TemporaryDirectory folder;
  const CachedMesh whole = bake_with_cache(tetrahedron(1), 32, folder.path());
  const std::string bytes = test::read_text(whole.file);
  std::string flipped = bytes;
  flipped[bytes.size() / 2] ^= 1;
  for (const std::string& damaged : {std::string(), bytes.substr(0, bytes.size() - 1), bytes + "x", flipped}) {
    test::write_text(whole.file, damaged);
    CHECK_FALSE(bake_with_cache(tetrahedron(1), 32, folder.path()).is_from_cache);
    CHECK(test::read_text(whole.file) == bytes);
  }
}

TEST_CASE("a cache that cannot be written is an error") {
  CHECK_FALSE(test::message_of<OutputError>([] { bake_with_cache(tetrahedron(1), 32, "/nonexistent"); }).empty());
}

TEST_CASE("the meshes of a scene are baked for the solver to find") {
  const test::TemporaryDirectory folder;
  Scene scene = test::small_scene(2, 2);
  KinematicObject object;
  object.name = "a";
  object.shape =
      MeshShape{{"a.obj", std::make_shared<TriangleMesh>(tetrahedron(1)), nullptr}, MeshUnit::m, 1.0, 32, {}};
  scene.objects = {object, object};
  int baked = 0;
  bake_meshes(scene, folder.path(), [&](const std::string&, double fraction) { baked += fraction == 1.0 ? 1 : 0; });
  CHECK(baked == 1);
  CHECK(std::get<MeshShape>(scene.objects[1].shape).file.distance->points[0] == 32);
}
