// There is no Embree (WEFTLIGHT_EMBREE is off): nothing is ray traced, and whoever asks reads why.

#include "base/text.h"
#include "reference/fibre_plan.h"
#include "reference/fibre_scene.h"
#include "reference/mesh_scene.h"
#include "reference/tubes.h"

namespace weftlight::reference {
namespace {

base::Failure missing() {
  return base::failure(base::ErrorKind::kGraphics,
                       base::tr("this build has no ray tracing; the desktop program compares with traced threads"));
}

}  // namespace

struct TubeScene::Parts {
  Cloth cloth;
};
TubeScene::TubeScene() = default;
TubeScene::~TubeScene() = default;
base::Result<std::unique_ptr<TubeScene>> TubeScene::build(const Cloth& /*cloth*/, const TubeOptions& /*options*/) {
  return missing();
}
bool TubeScene::intersect(glm::vec3 /*origin*/, glm::vec3 /*direction*/, float /*t_min*/, TubeHit& /*hit*/) const {
  return false;
}
bool TubeScene::occluded(glm::vec3 /*origin*/, glm::vec3 /*direction*/, float /*t_min*/) const { return false; }
float TubeScene::z_min() const { return 0; }
float TubeScene::z_max() const { return 0; }
const Cloth& TubeScene::cloth() const { return parts_->cloth; }

struct MeshScene::Parts {};
MeshScene::MeshScene() = default;
MeshScene::~MeshScene() = default;
base::Result<std::unique_ptr<MeshScene>> MeshScene::build(const Mesh& /*mesh*/) { return missing(); }
bool MeshScene::intersect(glm::vec3 /*origin*/, glm::vec3 /*direction*/, float /*t_min*/, MeshHit& /*hit*/) const {
  return false;
}
bool MeshScene::occluded(glm::vec3 /*origin*/, glm::vec3 /*direction*/, float /*t_min*/, float /*t_max*/) const {
  return false;
}

struct FibreScene::Parts {
  Cloth cloth;
  FibreFigures figures;
};
FibreScene::FibreScene() = default;
FibreScene::~FibreScene() = default;
base::Result<std::unique_ptr<FibreScene>> FibreScene::build(const Cloth& /*cloth*/, const FibreOptions& /*options*/) {
  return missing();
}
bool FibreScene::intersect(glm::vec3 /*origin*/, glm::vec3 /*direction*/, float /*t_min*/, FibreHit& /*hit*/) const {
  return false;
}
bool FibreScene::occluded(glm::vec3 /*origin*/, glm::vec3 /*direction*/, float /*t_min*/) const { return false; }
const Cloth& FibreScene::cloth() const { return parts_->cloth; }
const FibreFigures& FibreScene::figures() const { return parts_->figures; }
int64_t FibreScene::peak_bytes() const { return 0; }
float FibreScene::z_min() const { return 0; }
float FibreScene::z_max() const { return 0; }
float FibreScene::thickness_mm() const { return 0; }

}  // namespace weftlight::reference
