// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "host/rig.hpp"
#include <thread>
#include "scene/world.hpp"
#include "world.hpp"
