#pragma once

#include "engine/io/toml_reader.h"

#include <string_view>

/// Every section of a project file and every key that it may have: the one list that the reader obeys and
/// docs/project-format.md is tested against.
namespace luxdeck::project {

using Key = std::string_view;

inline constexpr Key kRootKeys[] = {"schema",      "requirements_file", "project",  "geometry", "material",
                                    "luminaire_type", "luminaire",      "sky",      "requirement", "grid",
                                    "view",        "volume",            "holodeck_section", "furniture"};
inline constexpr Key kInfoKeys[] = {"name", "client", "designer", "location", "date", "description", "notes"};
inline constexpr Key kGeometryKeys[] = {"file", "unit", "up", "translate", "rotate_z_deg", "scale"};
inline constexpr Key kMaterialKeys[] = {"name",     "kind",          "reflectance", "specular",       "roughness",
                                        "metallic", "transmittance", "ior",         "emission_cd_m2", "source",
                                        "roughness_u", "roughness_v", "grain", "diffuse_transmittance",
                                        "specular_transmittance", "transmittance_per_metre"};
inline constexpr Key kLuminaireTypeKeys[] = {"id",    "file",               "description",         "lumens",
                                             "watts", "maintenance_factor", "colour_temperature_k", "lamp_tilt"};
inline constexpr Key kLuminaireKeys[] = {"type",    "name",    "position",           "aim",
                                         "rotation_deg", "dimming", "maintenance_factor", "array",
                                         "orient",  "tilt",    "roll",               "spin"};
inline constexpr Key kArrayKeys[] = {"count", "spacing"};
inline constexpr Key kSkyKeys[] = {"kind",     "type",      "zenith_cd_m2", "horizontal_lux",     "ground_reflectance",      "sun",
                                   "sun_normal_lux", "sun_altitude_deg", "sun_azimuth_deg", "latitude", "longitude", "time_zone",
                                   "date",     "hour",      "weather",      "direct_normal_w_m2", "diffuse_horizontal_w_m2", "dew_point_c"};
inline constexpr Key kRequirementKeys[] = {"id", "name", "source", "mean_lux", "minimum_lux", "uniformity"};
inline constexpr Key kGridKeys[] = {"name",    "kind",   "origin", "u",           "v",           "border",
                                    "spacing", "counts", "points", "requirement", "requirements"};
inline constexpr Key kViewKeys[] = {"name",      "kind", "position",         "target",
                                    "direction", "up",   "vertical_fov_deg", "size"};
inline constexpr Key kVolumeKeys[] = {"name", "min", "max", "first_level", "second_level", "bins"};
inline constexpr Key kHolodeckKeys[] = {"name", "origin", "axes", "grid"};
inline constexpr Key kFurnitureKeys[] = {"object", "move", "turn_deg", "file", "name", "position", "rotation_deg",
                                            "movable", "unit", "up", "scale"};
inline constexpr Key kRequirementsFileKeys[] = {"schema", "requirement"};

inline constexpr TomlSection kRoot{"top level", kRootKeys};
inline constexpr TomlSection kInfo{"[project]", kInfoKeys};
inline constexpr TomlSection kGeometry{"[[geometry]]", kGeometryKeys};
inline constexpr TomlSection kMaterial{"[[material]]", kMaterialKeys};
inline constexpr TomlSection kLuminaireType{"[[luminaire_type]]", kLuminaireTypeKeys};
inline constexpr TomlSection kLuminaire{"[[luminaire]]", kLuminaireKeys};
inline constexpr TomlSection kArray{"array", kArrayKeys};
inline constexpr TomlSection kSky{"[sky]", kSkyKeys};
inline constexpr TomlSection kRequirement{"[[requirement]]", kRequirementKeys};
inline constexpr TomlSection kGrid{"[[grid]]", kGridKeys};
inline constexpr TomlSection kView{"[[view]]", kViewKeys};
inline constexpr TomlSection kVolume{"[[volume]]", kVolumeKeys};
inline constexpr TomlSection kHolodeck{"[[holodeck_section]]", kHolodeckKeys};
inline constexpr TomlSection kFurniture{"[[furniture]]", kFurnitureKeys};
inline constexpr TomlSection kRequirementsFile{"requirements file", kRequirementsFileKeys};

inline constexpr const TomlSection* kSections[] = {
    &kRoot, &kInfo,  &kGeometry, &kMaterial, &kLuminaireType, &kLuminaire, &kArray,           &kSky,
    &kRequirement, &kGrid, &kView, &kVolume, &kHolodeck,      &kFurniture, &kRequirementsFile};

}  // namespace luxdeck::project
