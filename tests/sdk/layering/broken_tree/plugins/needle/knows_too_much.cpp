// SPDX-License-Identifier: Apache-2.0
#include <swage/object.hpp>
#include "toolkit/math.hpp"
#include "../jaws/jaw.hpp"
#include "plugins/jaws/jaw.hpp"
#include "scene/world.hpp"
#include "arc.hpp"
#include "jaws/jaw.hpp"
