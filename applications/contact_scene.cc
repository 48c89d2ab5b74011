// SPDX-License-Identifier: LGPL-2.1-or-later

// Runs any scene that a parameter file describes.

#include "structure/driver.h"

int
main(int argc, char **argv)
{
  Structure::Driver driver;
  driver.name        = "contact_scene";
  driver.description = "Solids in contact, described by a parameter file.";
  driver.read        = Structure::read_scene;
  driver.defaults = []() { return Structure::default_scene("contact_scene"); };
  return Structure::run_driver(driver, argc, argv);
}
