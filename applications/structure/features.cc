// SPDX-License-Identifier: LGPL-2.1-or-later
#include "features.h"

#include <algorithm>

namespace Structure
{
  std::vector<Feature>
  features(const Scene &scene)
  {
    using Kind     = MortarContact::ContactParameters::Kind;
    using Rule     = MortarContact::Integration::Rule;
    Feature shells = {"shells", {}}, layers = {"plastic or rubber layers", {}},
            rigid = {"rigid bodies", {}}, loose = {"dofs of rigid bodies", {}},
            two_sweeps = {"both sides in turn", {}},
            self = {"self-contact", {}}, clipping = {"segmentation", {}},
            friction = {"friction", {}}, ties = {"ties", {}},
            damage    = {"failure of ties", {}},
            treatment = {"treatment of initial penetrations", {}},
            uzawa = {"augmentation", {}}, motion = {"inertia", {}},
            refinement = {"adaptive meshes", {}}, fluid = {"fluid", {}};
    for (const BodyParameters &body : scene.bodies)
      {
        const std::string where = "Bodies/" + body.name + "/";
        if (!body.is_shell)
          continue;
        shells.because.push_back(where + "Type = shell");
        if (body.material.hardening.yield_stress > 0.)
          layers.because.push_back(where + "Material/Yield stress");
        else if (body.material.law == "neo-Hookean")
          layers.because.push_back(where + "Material/Law = neo-Hookean");
      }
    for (const RigidParameters &body : scene.rigid_bodies)
      {
        const std::string where = "Rigid bodies/" + body.name;
        rigid.because.push_back(where);
        if (!body.free_motions.empty())
          loose.because.push_back(where + "/Free motions");
      }
    for (const InterfaceParameters &i : scene.interfaces)
      {
        const std::string                       where = "Contact/" + i.name;
        const MortarContact::ContactParameters &c     = i.contact;
        if (c.n_sweeps() == 2)
          two_sweeps.because.push_back(where + "/Kind");
        if (c.kind == Kind::automatic_single_surface)
          self.because.push_back(where + "/Kind");
        // smooth rigid surfaces have no segments
        const bool on_obstacle =
          std::any_of(scene.rigid_bodies.begin(),
                      scene.rigid_bodies.end(),
                      [&](const RigidParameters &r) {
                        return !i.primary.empty() &&
                               r.name == i.primary[0].body && r.type != "mesh";
                      });
        if (c.integration.rule == Rule::segments && !on_obstacle)
          clipping.because.push_back(where + "/Integration = segments");
        if (c.friction.is_on())
          friction.because.push_back(where + "/Friction ...");
        if (c.has_ties())
          ties.because.push_back(where + "/Kind");
        if (c.kind == Kind::tiebreak)
          damage.because.push_back(where + "/Kind = tiebreak");
        if (c.initial_penetration != MortarContact::InitialPenetration::stress)
          treatment.because.push_back(
            where + "/Initial penetration = " +
            MortarContact::to_string(c.initial_penetration));
        if (c.augmentation.is_on)
          uzawa.because.push_back(where + "/Augmentation");
      }
    if (scene.dynamics.is_on)
      motion.because.push_back("Dynamics/Type = dynamic");
    if (scene.refinement.is_on())
      refinement.because.push_back("Refinement");
    if (scene.valve.is_on)
      fluid.because.push_back("Load/Type = fluid");
    return {shells,
            layers,
            rigid,
            loose,
            two_sweeps,
            self,
            clipping,
            friction,
            ties,
            damage,
            treatment,
            uzawa,
            motion,
            refinement,
            fluid};
  }


  std::string
  text_of(const std::vector<Feature> &features)
  {
    std::string on = "On:", off;
    for (const Feature &feature : features)
      {
        if (feature.because.empty())
          {
            off += (off.empty() ? "" : ", ") + feature.name;
            continue;
          }
        on += "\n  " + feature.name + " (";
        for (std::size_t i = 0; i < feature.because.size(); ++i)
          on += (i > 0 ? ", " : "") + feature.because[i];
        on += ")";
      }
    return on + "\nOff, not stored, not computed: " + off + ".";
  }
} // namespace Structure
