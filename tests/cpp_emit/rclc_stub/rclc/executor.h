// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rclc/rclc.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    void* handles;
} rclc_executor_t;
typedef enum { ON_NEW_DATA, ALWAYS } rclc_executor_handle_invocation_t;
typedef void (*rclc_subscription_callback_t)(const void*);

rclc_executor_t rclc_executor_get_zero_initialized_executor(void);
ROBOCHART_USE_RESULT rcl_ret_t rclc_executor_init(rclc_executor_t*, rcl_context_t*, size_t handles,
                                                  const rcl_allocator_t*);
ROBOCHART_USE_RESULT rcl_ret_t rclc_executor_add_subscription(rclc_executor_t*, rcl_subscription_t*, void* message,
                                                              rclc_subscription_callback_t,
                                                              rclc_executor_handle_invocation_t);
ROBOCHART_USE_RESULT rcl_ret_t rclc_executor_add_timer(rclc_executor_t*, rcl_timer_t*);
ROBOCHART_USE_RESULT rcl_ret_t rclc_executor_spin(rclc_executor_t*);

#ifdef __cplusplus
}
#endif
