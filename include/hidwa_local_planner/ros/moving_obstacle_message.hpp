// SPDX-License-Identifier: BSD-3-Clause
// The message MovingObstacles. It and the core's list have one name in one namespace: here the message gets another.
#pragma once

#define MovingObstacle MovingObstacleMessage
#define MovingObstacles MovingObstaclesMessage
#include "hidwa_local_planner/MovingObstacles.h"
#undef MovingObstacle
#undef MovingObstacles
