// The assignment's own numbers, through its own names.
#include "pendula/actividad3.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <sstream>

#include "pendula/angle.hpp"

namespace {

using namespace pendula::actividad3;

std::string six_digits(double x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

TEST(Analisis, PrintsTheAssignmentsTable) {
    const struct {
        double theta, omega;
        int k;
        const char *theta_max, *tau;
    } rows[] = {
        {0.001, 0, -1, "0.001", "6.28319"},  {0.5, 0, -1, "0.5", "6.38279"},     {1, 0, -1, "1", "6.69998"},
        {1.5, 0, -1, "1.5", "7.30086"},      {2, 0, -1, "2", "8.34975"},         {2.5, 0, -1, "2.5", "10.3232"},
        {3, 0, -1, "3", "16.1555"},          {0, 2, 0, "3.14159", "7.14932"},    {0, -2, 0, "-3.14159", "7.14932"},
        {0.001, 2, 1, "3.14159", "17.9744"}, {0.01, 2, 1, "3.14159", "13.3692"}, {0.1, 2, 1, "3.14159", "8.76067"},
        {1, 2, 1, "3.14159", "4.12642"},
    };
    for (const auto& row : rows) {
        double theta_max = 0, tau = 0;
        int k = 7;
        analisis(1, row.theta, row.omega, 1e-7, theta_max, tau, k);
        EXPECT_EQ(k, row.k) << row.theta << ' ' << row.omega;
        EXPECT_EQ(six_digits(theta_max), row.theta_max) << row.theta << ' ' << row.omega;
        EXPECT_EQ(six_digits(tau), row.tau) << row.theta << ' ' << row.omega;
    }
}

TEST(RungeKutta, PrintsTheAssignmentsSampleRows) {
    const char* const want =
        "0 1.5708 0 1.5708\n"
        "0.148326 1.5598 -0.148324 1.55841\n"
        "0.296652 1.5268 -0.296595 1.52145\n"
        "0.444978 1.47183 -0.444542 1.46049\n"
        "0.593304 1.39497 -0.591471 1.3765\n";
    double theta = 90, theta_max = 0, tau = 0, omega = 0;
    int k = 0;
    ASSERT_TRUE(validaAngulo(theta, 's'));
    analisis(1, theta, omega, 1e-7, theta_max, tau, k);
    const double start = fase(theta / theta_max, omega), dt = 0.0001 * tau;
    std::ostringstream got;
    for (int step = 0; step <= 800; ++step) {
        const double t = step * dt;
        if (step % 200 == 0)
            got << t << ' ' << normaliza(theta) << ' ' << omega << ' '
                << normaliza(theta_max * std::sin(2 * pendula::pi * t / tau + start)) << '\n';
        RungeKutta(1, theta, omega, t, dt);
    }
    EXPECT_EQ(got.str(), want);
}

TEST(Analisis, FindsFigure3p2sPeriodTo12Pi) {
    double theta_max = 0, tau = 0;
    int k = 0;
    analisis(1, 0, 1.999999895801368, 1e-7, theta_max, tau, k);
    EXPECT_EQ(six_digits(tau), six_digits(12 * pendula::pi));
    EXPECT_EQ(k, -1);
}

TEST(ValidaAngulo, ConvertsKnownUnitsAndLeavesTheRest) {
    double theta = 180;
    EXPECT_TRUE(validaAngulo(theta, 's'));
    EXPECT_EQ(theta, pendula::pi);
    EXPECT_TRUE(validaAngulo(theta, 'r'));
    EXPECT_EQ(theta, pendula::pi);
    for (char unit : {'g', 'R', 'S', ' ', '\0'}) {
        EXPECT_FALSE(validaAngulo(theta, unit));
        EXPECT_EQ(theta, pendula::pi);
    }
}

TEST(Fase, IsTheLibrarysPhase) {
    EXPECT_EQ(fase(1.5, -1), pendula::pi / 2);
    EXPECT_EQ(fase(-1, 1), -pendula::pi / 2);
    for (double s : {-0.9, 0.0, 0.3}) {
        EXPECT_EQ(fase(s, 0), pendula::phase(s, 1));
        EXPECT_EQ(fase(s, -1), pendula::phase(s, -1));
        EXPECT_LT(std::cos(fase(s, -1)), 0);
    }
}

TEST(Normaliza, IsTheLibrarysWrap) {
    for (double theta : {0.0, 3.5, -3.5, pendula::pi, -pendula::pi, 1e15, 1.7e308})
        EXPECT_EQ(normaliza(theta), pendula::wrap(theta));
}

TEST(RungeKutta, LeavesTheAngleUnwrappedAndTheTimeAside) {
    double theta = 3, omega = 2, other_theta = 3, other_omega = 2;
    RungeKutta(1, theta, omega, 0, 0.2);
    RungeKutta(1, other_theta, other_omega, 1e9, 0.2);
    EXPECT_GT(theta, pendula::pi);
    EXPECT_EQ(theta, other_theta);
    EXPECT_EQ(omega, other_omega);
}

}  // namespace
