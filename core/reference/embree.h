#pragma once
// Embree 3 (Debian 12, Ubuntu 22.04) or 4 (Ubuntu 24.04): one ray against a scene.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <glm/glm.hpp>

namespace weftlight::reference {

/// Origin and direction in the space of the scene; hits from t_near to t_far count.
inline RTCRay ray_between(glm::vec3 origin, glm::vec3 direction, float t_near, float t_far) {
  RTCRay ray{};
  ray.org_x = origin.x, ray.org_y = origin.y, ray.org_z = origin.z;
  ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
  ray.tnear = t_near, ray.tfar = t_far, ray.mask = ~0u;
  return ray;
}

/// The closest hit of the ray, in `hit`. False: it hits nothing.
inline bool closest_hit(RTCScene scene, const RTCRay& ray, RTCRayHit& hit) {
  hit = {};
  hit.ray = ray;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &hit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &hit);
#endif
  return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

/// Whether the ray hits anything.
inline bool hits_any(RTCScene scene, RTCRay ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
  return ray.tfar < 0;
}

}  // namespace weftlight::reference
