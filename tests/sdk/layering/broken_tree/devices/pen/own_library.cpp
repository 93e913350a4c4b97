// SPDX-License-Identifier: Apache-2.0
#include <swage/device.hpp>
#include <HD/hd.h>
