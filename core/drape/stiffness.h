#pragma once
// How cloths unlike in stiffness hang: three of each drape, of which a cloth's bending length chooses.

#include <array>
#include <functional>
#include <string>

#include "drape/fabric.h"
#include "drape/mesh.h"
#include "drape/names.h"
#include "drape/solver.h"

namespace weftlight::drape {

/// Limp: crepe de chine and charmeuse, 12 mm. Medium: shirting, worsted, 19. Stiff: denim, linen, taffeta, 30.
enum class DrapeStiffness : uint8_t { kLimp, kMedium, kStiff };
inline constexpr std::array<DrapeStiffness, 3> kHangs{DrapeStiffness::kLimp, DrapeStiffness::kMedium,
                                                      DrapeStiffness::kStiff};
inline constexpr std::array<const char*, 3> kHangNames{"limp", "medium", "stiff"};

/// Of a cloth with that bending length (mm, Peirce's c); medium where it is not known (0).
DrapeStiffness drape_stiffness_of(double bending_length_mm);

/// The drape's own fabric, limper or stiffer.
Fabric with_stiffness(Fabric fabric, DrapeStiffness hang);

/// One cloth's, in steps that nobody sees: all of it that a simulation knows, and so the key of what came out. Weight
/// cancels out: it is in the bending length.
struct DrapeHandle {
  int half_mm = 38;         // of the bending length: 12..120
  int thickness_10um = 50;  // hundredths of a millimetre, in steps of five
  bool operator==(const DrapeHandle&) const = default;
};
DrapeHandle drape_handle(double bending_length_mm, double thickness_mm);
/// Of the mesh that is kept, without its ending: "tablecloth_19.0mm_0.50mm_v2".
std::string drape_file(const std::string& name, const DrapeHandle& hang);
/// Makes a drape's fabric and its fall those of the cloth.
void apply_handle(Fabric& fabric, Fall& fall, const DrapeHandle& hang);
/// As simulate_drape() of mesh.h, with a cloth's own stiffness in bending and in shear and its own thickness. `go_on`:
/// asked some hundred times, with the share that is done; false: leave it. Empty of what was left, of the plane and of
/// unknown names.
Mesh simulate_drape(const std::string& name, const DrapeHandle& hang,
                    const std::function<bool(double share)>& go_on = {}, float steps_scale = 1.0f);

/// As simulate_drape() of mesh.h, which is the medium one.
Mesh simulate_drape(const std::string& name, DrapeStiffness hang, float steps_scale = 1.0f);

/// Of the shipped mesh, without its ending: the drape's name, and its hang where it is not the medium one. The plane
/// has one alone.
std::string drape_file(const std::string& name, DrapeStiffness hang);

/// Share (0..1) of the ring between what it lies on and its own flat edge that a draped cloth covers, seen from
/// above: G. E. Cusick 1968, The measurement of fabric drape. support_mm: half the size of what it lies on, as a disc.
double drape_coefficient(const Mesh& mesh, double support_mm, double flat_area_mm2);

}  // namespace weftlight::drape
