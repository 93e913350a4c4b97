// SPDX-License-Identifier: Apache-2.0
#include <swage/object.hpp>
#include <swage/abi/lesson.h>
