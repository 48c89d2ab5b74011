// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_friction_law_h
#define mortar_contact_laws_friction_law_h

#include <memory>
#include <string>

namespace MortarContact
{
  /// Coefficient of friction at one contact point, with its derivatives.
  struct FrictionResponse
  {
    double coefficient = 0.; ///< mu >= 0 [-]
    double by_pressure = 0.; ///< dmu/dp [1/Pa]
    double by_rate     = 0.; ///< dmu/dv [s/m]
  };

  /**
   * Coefficient of isotropic friction: |tau| <= mu(p, v) p. Laws of a user's
   * own are derived from this class, see ContactInterface::set_friction_law().
   */
  class FrictionLaw
  {
  public:
    virtual ~FrictionLaw() = default;

    /// @param pressure Contact pressure p > 0 [Pa].
    /// @param rate     Slip of the step over its duration v >= 0 [m/s]; zero
    ///                 where a host does not tell the time.
    virtual FrictionResponse
    evaluate(const double pressure, const double rate) const = 0;
  };

  /// mu = FD + (FS - FD) exp(-DC v): static FS, dynamic FD, decay DC [s/m].
  /// With DC = 0 mu is FS at all rates.
  class CoulombFriction : public FrictionLaw
  {
  public:
    /// @param decay [s/m], see the class.
    CoulombFriction(const double static_coefficient,
                    const double dynamic_coefficient,
                    const double decay);

    FrictionResponse
    evaluate(const double pressure, const double rate) const override;

  private:
    double fs, fd, dc;
  };

  /// mu as a formula in p and v, for example "0.3/(1 + p/1e6)". Derivatives by
  /// central differences: their error, 1e-9 or so of mu, touches the speed of
  /// Newton's method, not its result.
  class FormulaFriction : public FrictionLaw
  {
  public:
    /// Negative values count as zero.
    /// @throw ExcMessage if @p formula is none.
    explicit FormulaFriction(const std::string &formula);
    ~FormulaFriction() override;

    FrictionResponse
    evaluate(const double pressure, const double rate) const override;

  private:
    struct Parser;
    std::unique_ptr<Parser> parser;
  };
} // namespace MortarContact

#endif
