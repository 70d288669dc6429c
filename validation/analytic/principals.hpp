#pragma once

#include "validation/analytic/field.hpp"

namespace cleave::analytic {

/// Principal values, descending, and unit directions of a symmetric tensor.
struct Principals {
    std::array<double, 3> value{};
    std::array<Point, 3> direction{};

    /// (largest - second) / Frobenius norm; 0 for a zero tensor.
    double gap() const;
};

/// By Jacobi's rotations (Golub and Van Loan, Matrix Computations, Sect. 8.5), to the last digit.
Principals principals(Gradient tensor);

/// The tensor of a stress, or of a strain with engineering shear.
Gradient stress_tensor(const Voigt& stress);
Gradient strain_tensor(const Voigt& strain);

/// S : sigma, engineering shear.
Voigt strain_under(const Stiffness& stiffness, const Voigt& stress);

/// Angle between two axes without sense, 0 to pi/2.
double angle_between(const Point& a, const Point& b);

}  // namespace cleave::analytic
