// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rclc/rclc.h"

typedef struct geometry_msgs__msg__Vector3 {
    double x, y, z;
} geometry_msgs__msg__Vector3;
typedef struct geometry_msgs__msg__Twist {
    geometry_msgs__msg__Vector3 linear, angular;
} geometry_msgs__msg__Twist;

#ifdef __cplusplus
extern "C" {
#endif
const rosidl_message_type_support_t* rosidl_typesupport_c__get_message_type_support_handle__geometry_msgs__msg__Twist(
    void);
#ifdef __cplusplus
}
#endif
