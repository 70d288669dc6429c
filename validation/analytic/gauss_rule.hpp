#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace cleave::analytic {

/// Points and weights of Gauss's rule on -1 to 1, by Newton's iteration on Legendre's polynomial.
inline std::vector<std::pair<double, double>> gauss_rule(int count) {
    std::vector<std::pair<double, double>> rule;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1;
        for (int step = 0; step < 60; ++step) {
            double below = 1, value = x;
            for (int k = 2; k <= count; ++k) {
                const double next = ((2 * k - 1) * x * value - (k - 1) * below) / k;
                below = value;
                value = next;
            }
            slope = count * (x * value - below) / (x * x - 1);
            x -= value / slope;
            if (std::abs(value / slope) < 1e-15) break;
        }
        rule.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace cleave::analytic
