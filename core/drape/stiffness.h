#pragma once
// Drapes by the stiffness of the fabric: three versions of each, chosen by the bending length of the cloth.

#include <array>
#include <functional>
#include <string>

#include "drape/fabric.h"
#include "drape/mesh.h"
#include "drape/solver.h"

namespace weftlight::drape {

/// Bending lengths: limp 12 mm (crepe de chine, charmeuse), medium 19 mm (shirting, worsted), stiff 30 mm (denim,
/// linen, taffeta).
enum class DrapeStiffness : uint8_t { kLimp, kMedium, kStiff };
inline constexpr std::array<DrapeStiffness, 3> kDrapeStiffnesses{DrapeStiffness::kLimp, DrapeStiffness::kMedium,
                                                                 DrapeStiffness::kStiff};
inline constexpr std::array<const char*, 3> kDrapeStiffnessNames{"limp", "medium", "stiff"};

/// For a bending length in mm (Peirce's c); medium if it is not known (0).
DrapeStiffness drape_stiffness_of(double bending_length_mm);

/// The fabric of a drape, made limper or stiffer.
Fabric with_stiffness(Fabric fabric, DrapeStiffness stiffness);

/// Everything that a simulation knows of one fabric, quantised in steps too small to see, and so the key of the result.
/// Weight is included in the bending length.
struct DrapeParameters {
  int bending_half_mm = 38;  // bending length in steps of 0.5 mm: 12..120
  int thickness_10um = 50;   // thickness in 0.01 mm, a multiple of 5
  bool operator==(const DrapeParameters&) const = default;
};
DrapeParameters drape_parameters(double bending_length_mm, double thickness_mm);
/// Name of the cached mesh without its extension: "tablecloth_19.0mm_0.50mm_v3".
std::string drape_file(const std::string& name, const DrapeParameters& parameters);
/// Applies the parameters of a fabric to a drape.
void apply_parameters(Fabric& fabric, Fall& fall, const DrapeParameters& parameters);
/// Like simulate_drape() of mesh.h, with the bending and shear stiffness and the thickness of one fabric. `keep_going`
/// is called some hundred times with the progress, 0 to 1; false stops. Empty if stopped, for the plane and for unknown
/// names.
Mesh simulate_drape(const std::string& name, const DrapeParameters& parameters,
                    const std::function<bool(double progress)>& keep_going = {}, float steps_scale = 1.0f);

/// Like simulate_drape() of mesh.h, which is the medium version.
Mesh simulate_drape(const std::string& name, DrapeStiffness stiffness, float steps_scale = 1.0f);

/// Name of the shipped mesh without its extension: the name of the drape, and its stiffness unless medium. The plane
/// has one version only.
std::string drape_file(const std::string& name, DrapeStiffness stiffness);

/// Drape coefficient (0..1): seen from above, the fraction that the draped cloth covers of the ring between its support
/// and its flat edge. G. E. Cusick 1968, The measurement of fabric drape. support_mm: radius of the support, a disc.
double drape_coefficient(const Mesh& mesh, double support_mm, double flat_area_mm2);

}  // namespace weftlight::drape
