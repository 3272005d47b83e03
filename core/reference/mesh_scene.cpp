#include "reference/mesh_scene.h"

#include <cstring>

#include "base/text.h"
#include "reference/embree.h"

namespace weftlight::reference {

using base::ErrorKind, base::failure, base::tr;
using drape::Vec2, drape::Vec3;

struct MeshScene::Parts {
  Mesh mesh;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Parts() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

MeshScene::MeshScene() : parts_(std::make_unique<Parts>()) {}
MeshScene::~MeshScene() = default;

base::Result<std::unique_ptr<MeshScene>> MeshScene::build(const Mesh& mesh) {
  std::unique_ptr<MeshScene> out(new MeshScene);
  Parts& parts = *out->parts_;
  parts.mesh = mesh;
  parts.device = rtcNewDevice(nullptr);
  if (mesh.index.empty()) return failure(ErrorKind::kInput, tr("the mesh has no triangles"));
  if (!parts.device) return failure(ErrorKind::kInput, tr("the ray tracer (Embree) could not be started"));
  parts.scene = rtcNewScene(parts.device);
  rtcSetSceneFlags(parts.scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(parts.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3),
                                           mesh.position_mm.size());
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t),
                                          mesh.index.size() / 3);
  const bool room = vertices && indices;
  if (room) {
    std::memcpy(vertices, mesh.position_mm.data(), mesh.position_mm.size() * sizeof(Vec3));
    std::memcpy(indices, mesh.index.data(), mesh.index.size() / 3 * 3 * sizeof(uint32_t));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(parts.scene, geometry);
    rtcCommitScene(parts.scene);
  }
  rtcReleaseGeometry(geometry);
  if (!room) return failure(ErrorKind::kMemory, tr("not enough memory for the mesh"));
  return out;
}

bool MeshScene::intersect(glm::vec3 origin, glm::vec3 direction, float t_min, MeshHit& hit) const {
  RTCRayHit ray;
  if (!closest_hit(parts_->scene, ray_between(origin, direction, t_min, kEndless), ray)) return false;
  const Mesh& mesh = parts_->mesh;
  const uint32_t* corner = &mesh.index[size_t{3} * ray.hit.primID];
  const float u = ray.hit.u, v = ray.hit.v, w = 1 - u - v;
  hit.t = ray.ray.tfar;
  hit.triangle = ray.hit.primID;
  hit.position = origin + direction * hit.t;
  hit.normal = glm::normalize(mesh.normal[corner[0]] * w + mesh.normal[corner[1]] * u + mesh.normal[corner[2]] * v);
  const glm::vec3 along = mesh.tangent[corner[0]] * w + mesh.tangent[corner[1]] * u + mesh.tangent[corner[2]] * v;
  hit.weft = glm::normalize(along - hit.normal * glm::dot(along, hit.normal));
  hit.warp = glm::cross(hit.normal, hit.weft);
  const Vec2 &a = mesh.uv_mm[corner[0]], &b = mesh.uv_mm[corner[1]], &c = mesh.uv_mm[corner[2]];
  hit.uv_mm = {a[0] * w + b[0] * u + c[0] * v, a[1] * w + b[1] * u + c[1] * v};
  const glm::vec3 face(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
  hit.front = (glm::dot(face, direction) < 0) == (glm::dot(face, hit.normal) > 0);
  return true;
}

bool MeshScene::occluded(glm::vec3 origin, glm::vec3 direction, float t_min, float t_max) const {
  return hits_any(parts_->scene, ray_between(origin, direction, t_min, t_max));
}

}  // namespace weftlight::reference
