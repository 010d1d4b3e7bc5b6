#include "epc/form/leading_form.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scaled_polynomials.hpp"

namespace fpkcheck::epc {
namespace {

using tests::kSigma;
using tests::radial;
using tests::scaled;

TEST(LeadingForm, OfAGaussianIsNegative) {
  const LeadingForm form = leading_form(radial(0), kSigma);
  EXPECT_TRUE(form.negative);
  EXPECT_EQ(form.rising_fraction, 0);
}

TEST(LeadingForm, MayVanishWhereALowerDegreeFalls) {
  EXPECT_TRUE(leading_form(scaled({{2, 0, -1}, {0, 2, -1}, {4, 0, -0.3}}), kSigma).negative);
  EXPECT_FALSE(leading_form(scaled({{2, 0, -1}, {0, 2, 1}, {4, 0, -0.3}}), kSigma).negative);
}

TEST(LeadingForm, IgnoresCoefficientsThatAreRounding) {
  EXPECT_TRUE(
      leading_form(scaled({{2, 0, -1}, {0, 2, -1}, {4, 0, -0.3}, {6, 0, 1e-14}}), kSigma).negative);
}

TEST(LeadingForm, NamesTheWorstDirectionAndTheRadius) {
  const LeadingForm form = leading_form(
      scaled({{2, 0, -0.5}, {0, 2, -0.5}, {4, 0, 1.0 / 64}, {2, 2, -1}, {0, 4, -0.1}}), kSigma);
  EXPECT_FALSE(form.negative);
  EXPECT_NEAR(std::abs(form.worst.x1), 1, 1e-12);
  EXPECT_NEAR(form.rises_from, 4, 0.02);
  EXPECT_GT(form.rising_fraction, 0);
  EXPECT_LT(form.rising_fraction, 0.2);
  EXPECT_EQ(leading_form(radial(0.01), kSigma).rising_fraction, 1);
}

TEST(LeadingForm, DetectsAnOddLeadingDegree) {
  const LeadingForm form = leading_form(scaled({{2, 0, -1}, {0, 2, -1}, {0, 3, 0.1}}), kSigma);
  EXPECT_FALSE(form.negative);
  EXPECT_NEAR(form.worst.x2, 1, 1e-12);
  EXPECT_NEAR(form.rising_fraction, 0.5, 1e-2);
}

TEST(LeadingForm, IsDescribedInText) {
  EXPECT_EQ(leading_form_text(leading_form(radial(0), kSigma), "(u, w)"),
            "although Q_n falls at infinity");
  EXPECT_EQ(
      leading_form_text(
          {.negative = false, .worst = {1, 0}, .rises_from = 4.017, .rising_fraction = 0.124},
          "(u, w)"),
      "and Q_n rises at infinity along 12 % of all directions, most steeply along (u, w) = (1.00, "
      "0.00) from radius 4.02 on");
}

}  // namespace
}  // namespace fpkcheck::epc
