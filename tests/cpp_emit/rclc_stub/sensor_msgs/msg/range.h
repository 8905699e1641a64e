// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rclc/rclc.h"

typedef struct sensor_msgs__msg__Range {
    float field_of_view, min_range, max_range, range;
} sensor_msgs__msg__Range;

#ifdef __cplusplus
extern "C" {
#endif
const rosidl_message_type_support_t* rosidl_typesupport_c__get_message_type_support_handle__sensor_msgs__msg__Range(
    void);
#ifdef __cplusplus
}
#endif
