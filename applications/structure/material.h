// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_material_h
#define mortar_contact_structure_material_h

#include "shell_law.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <memory>
#include <string>

namespace Structure
{
  using namespace dealii;

  /// Stress and stiffness of a solid at a point, in material form.
  struct StressResponse
  {
    double       energy = 0.; ///< Per undeformed volume [J/m^3]
    Tensor<2, 3> P;           ///< First Piola-Kirchhoff stress, dW/dF [Pa]
    Tensor<4, 3> A;           ///< dP/dF [Pa]
  };

  /// Volumetric part of the energy, U(J).
  struct VolumetricResponse
  {
    double energy     = 0.; ///< U [J/m^3]
    double pressure   = 0.; ///< dU/dJ, positive in tension [Pa]
    double derivative = 0.; ///< d2U/dJ2 [Pa]
  };

  /**
   * Hyperelastic material: deformation gradient in, stress out. Plane strain
   * uses the same laws with F_33 = 1.
   *
   * Every material obeys, and tests/structure/material.cc checks: P = dW/dF and
   * A = dP/dF by differences, P(Q F) = Q P(F) for rotations (not the linear
   * one), and Hooke's law at F = I.
   */
  class Material
  {
  public:
    virtual ~Material() = default;

    /// Response to F with det F > 0.
    virtual StressResponse
    evaluate(const Tensor<2, 3> &F) const = 0;

    /// Whether the energy is W_iso(J^(-1/3) F) + U(J), so that the mean
    /// dilatation can replace J.
    virtual bool
    is_split() const
    {
      return false;
    }

    /// For split materials: the first part, as a function of F.
    virtual StressResponse
    isochoric(const Tensor<2, 3> &F) const;

    /// For split materials: the second part.
    virtual VolumetricResponse
    volumetric(const double J) const;

    double shear_modulus = 0.; ///< At F = I [Pa]
    double bulk_modulus  = 0.; ///< At F = I [Pa]
    double density       = 0.; ///< Undeformed [kg/m^3]
    /// Bulk modulus for the contact stiffness, capped: see
    /// MortarContact::bulk_contact_modulus() [Pa].
    double contact_modulus = 0.;
    bool   is_linear       = false; ///< Small strains.
    /// W = mu/2 (I1 - 3 - 2 ln J) + lambda/2 (ln J)^2, or if it is split
    /// mu/2 (J^(-2/3) I1 - 3) + K/2 (J - 1)^2: see HexKernel.
    bool is_neo_hookean = false;
  };

  /// Settings of a material.
  struct MaterialParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    std::unique_ptr<Material>
    make() const;

    /// "automatic": neo-Hookean, of shells St. Venant-Kirchhoff.
    std::string law            = "automatic";
    double      youngs_modulus = 0.; ///< [Pa]
    double      poissons_ratio = 0.; ///< [-]
    double      C10 = 0., C01 = 0.;  ///< Mooney-Rivlin [Pa]
    double      density = 0.;        ///< [kg/m^3]
    Hardening   hardening;           ///< Of shells.
  };

  /// Young's modulus of rubber [MPa] from its Shore A hardness (Gent 1958,
  /// doi:10.5254/1.3542351): E = 0.0981 (56 + 7.62336 S) / (0.137505 (254 -
  /// 2.54 S)).
  double
  youngs_modulus_of_rubber(const double shore_a);
} // namespace Structure

#endif
