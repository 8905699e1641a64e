// SPDX-License-Identifier: Apache-2.0
// Stub of the C API of ROS 2 for microcontrollers (rclc of Humble): the declarations that docs/ros2.md uses, with the
// published names and types.
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t rcl_ret_t;
/// As in the published headers, a result that is not used is a warning.
#define ROBOCHART_USE_RESULT __attribute__((warn_unused_result))
#define RCL_RET_OK 0
#define RCL_MS_TO_NS(milliseconds) ((milliseconds) * (1000LL * 1000LL))

typedef struct rcl_allocator_s {
    void* state;
} rcl_allocator_t;
typedef struct rcl_context_s {
    void* impl;
} rcl_context_t;
typedef struct rcl_node_s {
    void* impl;
} rcl_node_t;
typedef struct rcl_publisher_s {
    void* impl;
} rcl_publisher_t;
typedef struct rcl_subscription_s {
    void* impl;
} rcl_subscription_t;
typedef struct rcl_timer_s {
    void* impl;
} rcl_timer_t;
typedef struct rmw_publisher_allocation_s rmw_publisher_allocation_t;
typedef struct rosidl_message_type_support_s {
    const char* typesupport_identifier;
} rosidl_message_type_support_t;
typedef void (*rcl_timer_callback_t)(rcl_timer_t*, int64_t);

typedef struct {
    rcl_context_t context;
    rcl_allocator_t* allocator;
} rclc_support_t;

rcl_allocator_t rcl_get_default_allocator(void);
rcl_node_t rcl_get_zero_initialized_node(void);
rcl_publisher_t rcl_get_zero_initialized_publisher(void);
rcl_subscription_t rcl_get_zero_initialized_subscription(void);
rcl_timer_t rcl_get_zero_initialized_timer(void);
ROBOCHART_USE_RESULT rcl_ret_t rcl_timer_cancel(rcl_timer_t*);
ROBOCHART_USE_RESULT rcl_ret_t rcl_publish(const rcl_publisher_t*, const void* message, rmw_publisher_allocation_t*);

ROBOCHART_USE_RESULT rcl_ret_t rclc_support_init(rclc_support_t*, int count, char const* const* words,
                                                 rcl_allocator_t*);
ROBOCHART_USE_RESULT rcl_ret_t rclc_node_init_default(rcl_node_t*, const char* name, const char* space,
                                                      rclc_support_t*);
ROBOCHART_USE_RESULT rcl_ret_t rclc_publisher_init_default(rcl_publisher_t*, const rcl_node_t*,
                                                           const rosidl_message_type_support_t*, const char* topic);
ROBOCHART_USE_RESULT rcl_ret_t rclc_subscription_init_default(rcl_subscription_t*, rcl_node_t*,
                                                              const rosidl_message_type_support_t*, const char* topic);
ROBOCHART_USE_RESULT rcl_ret_t rclc_subscription_init_best_effort(rcl_subscription_t*, rcl_node_t*,
                                                                  const rosidl_message_type_support_t*,
                                                                  const char* topic);
ROBOCHART_USE_RESULT rcl_ret_t rclc_timer_init_default(rcl_timer_t*, rclc_support_t*, uint64_t nanoseconds,
                                                       rcl_timer_callback_t);

#define ROSIDL_GET_MSG_TYPE_SUPPORT(package, folder, message) \
    rosidl_typesupport_c__get_message_type_support_handle__##package##__##folder##__##message()

#ifdef __cplusplus
}
#endif
