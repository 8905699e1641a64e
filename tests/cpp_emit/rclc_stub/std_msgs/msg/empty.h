// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rclc/rclc.h"

typedef struct std_msgs__msg__Empty {
    uint8_t structure_needs_at_least_one_member;
} std_msgs__msg__Empty;

#ifdef __cplusplus
extern "C" {
#endif
const rosidl_message_type_support_t* rosidl_typesupport_c__get_message_type_support_handle__std_msgs__msg__Empty(void);
#ifdef __cplusplus
}
#endif
