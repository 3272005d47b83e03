#include "reference/interreflection.h"

#include <algorithm>

#include "cloth/centre_step.h"
#include "light/formulas.h"
#include "light/yarn_lobes.h"

namespace weftlight::reference {

using cloth::Cloth, cloth::ThreadBody, cloth::centre_step;
using draft::System;

namespace {

constexpr int kThreadsAside = 2;  // on each side of a thread: about the yarns that the preview takes

/// Means over neighbours, wrapped.
std::vector<glm::vec3> smoothed(const std::vector<glm::vec3>& of, int aside) {
  const int n = static_cast<int>(of.size());
  std::vector<glm::vec3> out;
  out.reserve(of.size());
  for (int i = 0; i < n; ++i) {
    glm::vec3 sum(0);
    for (int k = -aside; k <= aside; ++k) sum += of[static_cast<size_t>(((i + k) % n + n) % n)];
    out.push_back(sum / static_cast<float>(2 * aside + 1));
  }
  return out;
}

std::vector<glm::vec3> mean_everywhere(const std::vector<glm::vec3>& of) {
  glm::vec3 sum(0);
  for (const glm::vec3& c : of) sum += c;
  return std::vector<glm::vec3>(of.size(), of.empty() ? sum : sum / static_cast<float>(of.size()));
}

}  // namespace

glm::vec3 reflectance_of(const Cloth& cloth, const ThreadBody& body) {
  const formulas::YarnLobes lobes = light::yarn_lobes(cloth.yarns[static_cast<size_t>(body.yarn)].lobes, body.colour);
  return formulas::unhidden_reflectance(lobes);
}

Interreflection::Interreflection(const Cloth& cloth, const HiddenParts& hidden) : cloth_(cloth) {
  for (size_t s = 0; s < 2; ++s) {
    std::vector<glm::vec3> own;
    for (const ThreadBody& body : s == 0 ? cloth.ends : cloth.picks)
      own.push_back(hidden[s] * reflectance_of(cloth, body));
    sent_[s] = cloth.layers.empty() ? smoothed(own, kThreadsAside) : mean_everywhere(own);
  }
}

glm::vec3 Interreflection::alone(glm::vec2 position) const {
  if (sent_[0].empty() || sent_[1].empty()) return glm::vec3(1);
  glm::vec3 sent = sent_[0].front() + sent_[1].front();
  if (cloth_.layers.empty()) {
    const auto thread_at = [this](System across, float at) {
      const auto step = centre_step(cloth_, across, at);
      return static_cast<size_t>(std::max(step.t < 0.5f ? step.crossing : step.crossing + 1, 0));
    };
    // Along a pick one meets ends, along an end picks.
    const size_t end = thread_at(System::kWeft, position.x), pick = thread_at(System::kWarp, position.y);
    sent = sent_[0][end % sent_[0].size()] + sent_[1][pick % sent_[1].size()];
  }
  return formulas::reflected_alone(sent);
}

}  // namespace weftlight::reference
