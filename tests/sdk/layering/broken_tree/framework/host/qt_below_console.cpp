// SPDX-License-Identifier: Apache-2.0
#include <QString>
#include <QtCore/QObject>
#include <nlohmann/json.hpp>
#include <sys/types.h>
