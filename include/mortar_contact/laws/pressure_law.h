// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_pressure_law_h
#define mortar_contact_laws_pressure_law_h

namespace MortarContact
{
  /// Response of a normal law at one contact point.
  struct NormalResponse
  {
    double energy    = 0.; ///< psi(d), integral of the pressure [Pa m].
    double pressure  = 0.; ///< p(d) = dpsi/dd [Pa].
    double stiffness = 0.; ///< dp/dd [Pa/m].
  };

  /**
   * Normal contact law: penetration in, pressure out.
   *
   * Laws are free of units: p = K phi(d / l) with the contact modulus K and the
   * characteristic length l of the facets. A law gives phi with its integral
   * and its derivative; hence dp/dK = p/K and dp/dl = -(d/l) dp/dd for all.
   *
   * Every law obeys, and tests/laws/pressure_law.cc checks for every law in
   * law_library.h,
   *   phi = 0 for d <= 0,   phi' >= 0,   phi and its integral continuous,
   *   the integral's derivative is phi, phi' by central differences.
   */
  class PressureLaw
  {
  public:
    virtual ~PressureLaw() = default;

    /// @param depth d / l, dimensionless, positive.
    /// @return The integral of phi from 0 to depth, phi, and phi'.
    virtual NormalResponse
    normalised(const double depth) const = 0;

    /// Depth d / l at which phi is @p pressure: the inverse for positive
    /// pressures, zero else.
    virtual double
    inverse(const double pressure) const = 0;

    /**
     * @param penetration d [m]; no response for d <= 0 (open).
     * @param modulus     Contact modulus K [Pa], positive.
     * @param length      Characteristic length l [m], positive.
     */
    NormalResponse
    evaluate(const double penetration,
             const double modulus,
             const double length) const
    {
      if (!(penetration > 0.))
        return {};
      NormalResponse r = normalised(penetration / length);
      r.energy *= modulus * length;
      r.pressure *= modulus;
      r.stiffness *= modulus / length;
      return r;
    }
  };
} // namespace MortarContact

#endif
