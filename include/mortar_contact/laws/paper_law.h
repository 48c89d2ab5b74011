// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_paper_law_h
#define mortar_contact_laws_paper_law_h

#include <mortar_contact/laws/pressure_law.h>

namespace MortarContact
{
  /// First part f0(x) of the law, x = d / (eps l), before progressive
  /// stiffening. All have f0(0) = 0; values at x = 1 and 2 are given.
  enum class PressureCurve
  {
    parabola_linear, ///< x^2/4 up to 2, then x - 1 (1/4, 1): C1.
    parabola,        ///< x^2/4 (1/4, 1): C-infinity, ever stiffer.
    quartic_linear,  ///< x^3/4 - x^4/16 up to 2, then x - 1 (3/16, 1): C2.
    linear           ///< x (1, 2): stiff at once, C0.
  };

  /**
   * The law of LS-DYNA's Mortar contact (T. Borrvall, Mortar Contact for
   * Implicit Analysis, section "Contact pressure and release"),
   *   p = alpha eps K f(d / (eps l)),
   * with f = f0 + (IGAP - 1) f0(x_m) max(s, 0)^3, s = (x - x_q)/(x_m - x_q):
   * progressive stiffening between half the largest penetration (x_q) and the
   * largest penetration (x_m), C2 at x_q, exactly IGAP times f0 at x_m. The
   * paper describes the branch in words only; the cubic is ours.
   *
   * Beyond the largest penetration the law goes on along its tangent: iterates
   * may go there, converged states may not (see ContactInterface).
   *
   * As a barrier ("never release") s^3 is replaced by s^3/(1 - s), times
   * max(IGAP - 1, 1) f0(x_m): no finite pressure reaches the largest
   * penetration. From s = 0.99 on, where pressures are 97 f0(x_m) and more, it
   * goes on along its tangent, so that iterates may pass.
   *
   * Default numbers: p(2 eps l) = alpha eps K, p(l/4) = 0.22 alpha K,
   * p(l/2) = 0.47 alpha K, plateau stiffness alpha K / l.
   */
  class PaperLaw : public PressureLaw
  {
  public:
    /**
     * @param scale       alpha = SFS * SLSFAC, positive.
     * @param stiffening  IGAP >= 1; 1 means none.
     * @param largest     Largest penetration as a share of l, in (0, 1]: 1/2.
     * @param barrier     Whether no pressure reaches the largest penetration.
     * @param width       eps, width of the smooth start as a share of l: 0.03.
     */
    PaperLaw(const PressureCurve curve,
             const double        scale,
             const double        stiffening = 1.,
             const double        largest    = 0.5,
             const double        width      = 0.03,
             const bool          barrier    = false);

    /// Start of the continuation of a barrier, as s.
    static constexpr double barrier_end = 0.99;

    NormalResponse
    normalised(const double depth) const override;

    double
    inverse(const double pressure) const override;

  private:
    /// f and its integral and derivative for 0 <= x <= x_end.
    NormalResponse
    curve_at(const double x) const;

    PressureCurve  curve;
    double         scale, width;
    bool           barrier;
    double         x_q, x_m; ///< Start and end of stiffening.
    double         x_end;    ///< Start of the continuation.
    double         cubic;    ///< (IGAP - 1) f0(x_m), or the barrier's factor.
    NormalResponse at_end;   ///< f at x_end.
  };
} // namespace MortarContact

#endif
