// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_contact_modulus_h
#define mortar_contact_laws_contact_modulus_h

#include <algorithm>

namespace MortarContact
{
  /**
   * Contact modulus of an isotropic solid, its bulk modulus
   * K = E / (3 (1 - 2 nu)) [Pa], as LS-DYNA takes it. Poisson's ratio is capped
   * at 0.499: beyond, the bulk modulus says nothing about the solid's stiffness
   * any more and would only spoil the conditioning.
   */
  inline double
  bulk_contact_modulus(const double youngs_modulus, const double poissons_ratio)
  {
    return youngs_modulus / (3. * (1. - 2. * std::min(poissons_ratio, 0.499)));
  }

  /// Contact modulus and characteristic length at a contact point.
  struct ContactStiffness
  {
    double modulus = 0.; ///< K [Pa]
    double length  = 0.; ///< l [m]
  };

  /**
   * Two sides as springs in series, each of stiffness K/l per area. With the
   * compliances c = l/K the pair has the compliance c_s + c_p and the mean
   * length l = (c_s l_s + c_p l_p)/(c_s + c_p): each side contributes as it
   * gives way. Symmetric in the sides; with a rigid side (c = 0) the other
   * side's values.
   */
  inline ContactStiffness
  in_series(const double compliance_s,
            const double length_s,
            const double compliance_p,
            const double length_p)
  {
    const double c = compliance_s + compliance_p;
    const double l = (compliance_s * length_s + compliance_p * length_p) / c;
    return {l / c, l};
  }
} // namespace MortarContact

#endif
