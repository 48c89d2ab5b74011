// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_rigid_motion_h
#define mortar_contact_geometry_rigid_motion_h

#include <deal.II/base/tensor.h>

namespace MortarContact
{
  using namespace dealii;

  /// Rotation about a point of the body, then translation:
  ///   x = X_c + u + R (X - X_c).
  template <int dim>
  struct RigidMotion
  {
    RigidMotion()
    {
      for (unsigned int i = 0; i < dim; ++i)
        rotation[i][i] = 1.;
    }

    Tensor<2, dim> rotation;    ///< R
    Tensor<1, dim> centre;      ///< X_c [m]
    Tensor<1, dim> translation; ///< u [m]

    /// Where the point of the body that was at @p X is.
    Tensor<1, dim>
    place(const Tensor<1, dim> &X) const
    {
      return centre + translation + rotation * (X - centre);
    }

    /// Which point of the body is at @p x.
    Tensor<1, dim>
    origin(const Tensor<1, dim> &x) const
    {
      return centre + transpose(rotation) * (x - centre - translation);
    }

    /// For checkpoints and between ranks.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &rotation &centre &translation;
    }
  };

  /// Rotation by the vector @p v: about its direction by its length [rad]; in
  /// 2d by its last component, counter-clockwise. Rodrigues' formula.
  template <int dim>
  Tensor<2, dim>
  rotation_by(const Tensor<1, 3> &v);

  template <>
  inline Tensor<2, 2>
  rotation_by<2>(const Tensor<1, 3> &v)
  {
    Tensor<2, 2> R;
    R[0][0] = R[1][1] = std::cos(v[2]);
    R[1][0]           = std::sin(v[2]);
    R[0][1]           = -R[1][0];
    return R;
  }

  template <>
  inline Tensor<2, 3>
  rotation_by<3>(const Tensor<1, 3> &v)
  {
    const double angle = v.norm();
    Tensor<2, 3> W;
    W[0][1] = -v[2];
    W[0][2] = v[1];
    W[1][0] = v[2];
    W[1][2] = -v[0];
    W[2][0] = -v[1];
    W[2][1] = v[0];
    // sin(t)/t and (1 - cos(t))/t^2, by their series for small t
    const double t2 = angle * angle;
    const double a  = (angle < 1e-4) ? 1. - t2 / 6. : std::sin(angle) / angle;
    const double b =
      (angle < 1e-4) ? 0.5 - t2 / 24. : (1. - std::cos(angle)) / t2;
    Tensor<2, 3> R = a * W + b * (W * W);
    for (unsigned int i = 0; i < 3; ++i)
      R[i][i] += 1.;
    return R;
  }
} // namespace MortarContact

#endif
