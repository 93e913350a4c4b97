// SPDX-License-Identifier: Apache-2.0
#include <QWidget>
#include <Qt3DCore/QEntity>
#include "console/cues.hpp"
#include "session/session.hpp"
#include "host/params.hpp"
#include "host/rig.hpp"
#include "step/step.hpp"
