#include "validation/symmetry_class.hpp"

#include "solver/material/material.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

namespace cleave::validation {
namespace {

/// Nye's forms (1985, Table 9), crystal axes along x, y, z, with numbers that belong to no higher class.
material::Stiffness form_of(const std::string& symmetry) {
    material::Stiffness c = material::Stiffness::Zero();
    const auto set = [&](int i, int j, double value) { c(i - 1, j - 1) = c(j - 1, i - 1) = value; };
    for (const auto& [i, value] : {std::pair{1, 90.0}, {2, 70.0}, {3, 110.0}, {4, 30.0}, {5, 24.0}, {6, 28.0}}) set(i, i, value);
    set(1, 2, 20), set(1, 3, 25), set(2, 3, 15);
    if (symmetry == "triclinic") set(1, 4, 5), set(2, 5, -7), set(3, 6, 4), set(4, 5, 3), set(1, 5, 6), set(4, 6, -2);
    if (symmetry == "monoclinic") set(1, 5, 8), set(2, 5, -4), set(3, 5, 6), set(4, 6, 5);
    if (symmetry == "triclinic" || symmetry == "monoclinic" || symmetry == "orthotropic") return c;
    set(2, 2, 90), set(2, 3, 25), set(5, 5, 30);
    if (symmetry == "tetragonal") return c;
    set(6, 6, 35);
    if (symmetry == "trigonal") set(1, 4, 12), set(2, 4, -12), set(5, 6, 12);
    if (symmetry == "trigonal" || symmetry == "transversely isotropic") return c;
    set(3, 3, 90), set(1, 2, 25), set(6, 6, 30);
    if (symmetry == "cubic") return c;
    for (const int i : {4, 5, 6}) set(i, i, 32.5);
    return c;
}

TEST(SymmetryClass, NyesFormsInAnyAxes) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.83, Eigen::Vector3d(1, -2, 0.7).normalized()).toRotationMatrix();
    for (const std::string& symmetry : symmetry_classes()) {
        EXPECT_EQ(symmetry_class(form_of(symmetry)), symmetry);
        EXPECT_EQ(symmetry_class(material::rotate_stiffness(form_of(symmetry), turn)), symmetry) << "turned";
    }
}

TEST(SymmetryClass, MaterialsAsTheirCrystalsAre) {
    for (const auto& [name, symmetry] : std::map<std::string, std::string>{{"quartz", "trigonal"}, {"sapphire", "trigonal"}, {"calcite", "trigonal"},
             {"silicon", "cubic"}, {"ice", "transversely isotropic"}, {"olivine", "orthotropic"}, {"orthoclase", "monoclinic"}, {"albite", "triclinic"},
             {"stishovite", "tetragonal"}, {"steel", "isotropic"}, {"T300/5208", "transversely isotropic"}, {"Sitka spruce", "orthotropic"}})
        EXPECT_EQ(symmetry_class(material::find_material(name).stiffness), symmetry) << name;
}

material::Stiffness cubic(double c11, double c12, double c44) {
    material::Stiffness c = material::Stiffness::Zero();
    c.topLeftCorner<3, 3>().setConstant(c12);
    c.diagonal() << c11, c11, c11, c44, c44, c44;
    return c;
}

// One per cent off isotropy the anisotropic part is as small as the tolerance: planes that are none must not count.
TEST(SymmetryClass, NearlyIsotropic) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.83, Eigen::Vector3d(1, -2, 0.7).normalized()).toRotationMatrix();
    const material::Stiffness barely = cubic(165.7, 63.9, 51.4);
    EXPECT_EQ(symmetry_class(barely), "cubic");
    EXPECT_EQ(symmetry_class(material::rotate_stiffness(barely, turn)), "cubic");
    EXPECT_EQ(symmetry_class(cubic(165.7, 63.9, 50.95)), "isotropic");
}

TEST(SymmetryClass, AnyUnit) {
    for (const std::string& symmetry : symmetry_classes())
        for (const double unit : {1e-250, 1e-9, 1e9, 1e250}) EXPECT_EQ(symmetry_class(unit * form_of(symmetry)), symmetry) << unit;
}

// Eigenvectors without a symmetry: no mirror, however far the eigenvalues lie apart. At the last the softest directions weigh 1e-8 of
// the norm, far less than the tolerance: three stiff ones are enough to tell.
TEST(SymmetryClass, AnyCondition) {
    std::srand(3);  // Eigen's Random
    for (const double condition : {10.0, 1e4, 1e8}) {
        for (int i = 0; i < 5; ++i) {
            const Eigen::Matrix<double, 6, 6> basis = Eigen::HouseholderQR<Eigen::Matrix<double, 6, 6>>(Eigen::Matrix<double, 6, 6>::Random()).householderQ();
            Eigen::Vector<double, 6> moduli;
            for (int k = 0; k < 6; ++k) moduli[k] = k < 3 ? 1 + k : 3 * std::pow(condition, -(k - 2) / 3.0);
            material::Stiffness c = basis * moduli.asDiagonal() * basis.transpose();  // Kelvin's matrix, back to Voigt's below
            c.topRightCorner<3, 3>() /= std::sqrt(2.0), c.bottomLeftCorner<3, 3>() /= std::sqrt(2.0), c.bottomRightCorner<3, 3>() /= 2;
            EXPECT_EQ(symmetry_class(c), "triclinic") << condition << ", " << i;
        }
    }
}

// The must-fail twin: a change ten times the tolerance takes a tensor out of its class.
TEST(SymmetryClass, ASmallCouplingIsSeen) {
    material::Stiffness c = form_of("cubic");
    c(0, 4) = c(4, 0) = 5;
    EXPECT_NE(symmetry_class(c), "cubic");
}

}  // namespace
}  // namespace cleave::validation
