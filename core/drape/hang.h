#pragma once
// How cloths unlike in stiffness hang: three of each drape, of which a cloth's bending length chooses.

#include <array>
#include <string>

#include "drape/fabric.h"
#include "drape/mesh.h"
#include "drape/names.h"

namespace weftlight::drape {

/// Limp: crepe de chine and charmeuse, 12 mm. Medium: shirting, worsted, 19. Stiff: denim, linen, taffeta, 30.
enum class Hang : uint8_t { kLimp, kMedium, kStiff };
inline constexpr std::array<Hang, 3> kHangs{Hang::kLimp, Hang::kMedium, Hang::kStiff};
inline constexpr std::array<const char*, 3> kHangNames{"limp", "medium", "stiff"};

/// Of a cloth with that bending length (mm, Peirce's c); medium where it is not known (0).
Hang hang_of(double bending_length_mm);

/// The drape's own fabric, limper or stiffer.
Fabric in_hang(Fabric fabric, Hang hang);

/// As simulate_drape() of mesh.h, which is the medium one.
Mesh simulate_drape(const std::string& name, Hang hang, float steps_scale = 1.0f);

/// Of the shipped mesh, without its ending: the drape's name, and its hang where it is not the medium one. The plane
/// has one alone.
std::string drape_file(const std::string& name, Hang hang);

/// Share (0..1) of the ring between what it lies on and its own flat edge that a draped cloth covers, seen from
/// above: G. E. Cusick 1968, The measurement of fabric drape. support_mm: half the size of what it lies on, as a disc.
double drape_coefficient(const Mesh& mesh, double support_mm, double flat_area_mm2);

}  // namespace weftlight::drape
