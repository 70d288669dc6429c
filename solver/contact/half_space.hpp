#pragma once

#include "solver/contact/contact_load.hpp"
#include "solver/material/stiffness.hpp"

#include <memory>
#include <span>

namespace cleave::contact {

/// How the fields of a half-space are computed.
enum class HalfSpaceForm {
    automatic,    ///< closed where the material is isotropic (to 1e-9 of its stiffness) and the patch no ellipse, else stroh
    closed,       ///< Boussinesq, Cerruti, Hertz: real and complex elementary functions; isotropic materials only
    stroh         ///< Stroh's formalism, any stiffness: a sum over directions of the surface
};

struct HalfSpaceOptions {
    HalfSpaceForm form = HalfSpaceForm::automatic;
    double accuracy = 1e-7;      ///< of Stroh's sum, relative: sets the number of directions, point by point
    int most_directions = 4096;  ///< of a full turn; points so shallow that they would need more are extrapolated from deeper ones
    /// Displacements outside the patch from a table of the whole half-space (green_table.hpp), made with it in the time of some hundred
    /// contacts: for many contacts under one direction of the surface. Of no effect where the closed form does.
    bool tabulated = false;
};

class GreenTable;
class StrohField;
struct IsotropicContact;
class StrohTable;

/// A half-space of one material under one direction of its surface: what contacts can share. Where the closed forms do, making it is
/// cheap; else the Stroh eigenvectors of each direction are found when a field first needs them and kept. Safe to share between threads.
class HalfSpace {
public:
    /// `stiffness` in Pa, in the axes of `inward`. Throws std::invalid_argument: closed form of an anisotropic stiffness, no normal.
    HalfSpace(const material::Stiffness& stiffness, const Eigen::Vector3d& inward, const HalfSpaceOptions& options = {});

    const material::Stiffness& stiffness() const { return stiffness_; }
    const Eigen::Vector3d& inward() const { return inward_; }
    const HalfSpaceOptions& options() const { return options_; }
    bool isotropic() const { return isotropic_; }
    double shear_modulus() const { return shear_modulus_; }    ///< Pa, of an isotropic material
    double poisson_ratio() const { return poisson_ratio_; }
    std::shared_ptr<const StrohTable> stroh_table() const { return stroh_table_; }  ///< in surface_axes(inward)
    const GreenTable* green_table() const { return green_table_.get(); }            ///< null where not asked for

private:
    material::Stiffness stiffness_;
    Eigen::Vector3d inward_;
    HalfSpaceOptions options_;
    bool isotropic_ = false;
    double shear_modulus_ = 0, poisson_ratio_ = 0;
    std::shared_ptr<const StrohTable> stroh_table_;
    std::shared_ptr<const GreenTable> green_table_;
};

/// True where a stiffness equals that of an isotropic material to `tolerance` of its largest entry.
bool is_isotropic(const material::Stiffness& stiffness, double tolerance = 1e-9);

/// Fields of one contact in a half-space (the paper's displacement of the neighbours, Sect. 4.2). The surface is the plane through the
/// contact's point; a place outside it (a hollow body) takes the values of the surface below it. A point force makes infinite fields at
/// its own point.
class HalfSpaceField {
public:
    /// `load.inward` is taken from the half-space where the load's differs by rounding only.
    /// Throws std::invalid_argument: normals that differ, a closed form asked for an ellipse.
    HalfSpaceField(std::shared_ptr<const HalfSpace> half_space, const ContactLoad& load);

    Eigen::Vector3d displacement(const Eigen::Vector3d& position) const;       ///< m, zero far away
    Eigen::Matrix3d gradient(const Eigen::Vector3d& position) const;           ///< du_a / dx_b
    material::Voigt stress(const Eigen::Vector3d& position) const;             ///< Pa

    /// Displacements of many places: the same bits, faster where closed forms do.
    void displacements(std::span<const Eigen::Vector3d> positions, std::span<Eigen::Vector3d> displacement) const;

    const ContactLoad& load() const { return load_; }
    const HalfSpace& half_space() const { return *half_space_; }

private:
    Eigen::Vector3d to_local(const Eigen::Vector3d& position) const;
    IsotropicContact isotropic_contact() const;

    std::shared_ptr<const HalfSpace> half_space_;
    ContactLoad load_;
    Eigen::Matrix3d axes_;            // columns: tangents, inward normal
    Eigen::Vector3d local_force_;
    bool closed_ = false, tabulated_ = false;
    std::shared_ptr<const StrohField> stroh_;  // where not closed
};

/// Field of one contact, for a single use.
HalfSpaceField half_space_field(const material::Stiffness& stiffness, const ContactLoad& load, const HalfSpaceOptions& options = {});

}  // namespace cleave::contact
