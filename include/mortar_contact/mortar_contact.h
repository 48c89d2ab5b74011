// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_contact_h
#define mortar_contact_mortar_contact_h

// Everything that a program needs; begin with MortarContact::ContactInterface.

#include <mortar_contact/host/contact_interface.h>
#include <mortar_contact/host/contact_output.h>
#include <mortar_contact/host/contact_preconditioner.h>
#include <mortar_contact/laws/contact_modulus.h>
#include <mortar_contact/parameters/contact_parameters.h>

#endif
