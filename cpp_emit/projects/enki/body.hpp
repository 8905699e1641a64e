// An e-puck in Enki with the sensors and actuators that its controller uses; centimetres, seconds, radians. Generated
// by robochart-verify.
#pragma once

#include <enki/PhysicalEngine.h>
#include <enki/robots/e-puck/EPuck.h>

#include <algorithm>
#include <cmath>
#include <limits>

/// The line of sight: finds the first object on a ray from the robot's front edge along its heading.
class Eye final : public Enki::LocalInteraction {
public:
    explicit Eye(Enki::Robot* robot) : Enki::LocalInteraction(1e6, robot) {}

    void init(double, Enki::World*) override { robot_ = wall_ = std::numeric_limits<double>::infinity(); }
    void objectStep(double, Enki::World*, Enki::PhysicalObject* object) override {
        const double x = object->pos.x - owner->pos.x;
        const double y = object->pos.y - owner->pos.y;
        const double along = x * std::cos(owner->angle) + y * std::sin(owner->angle);
        const double aside = y * std::cos(owner->angle) - x * std::sin(owner->angle);
        const double radius = object->getRadius();
        if (along <= 0 || std::abs(aside) > radius) return;
        robot_ = std::min(robot_, along - std::sqrt(radius * radius - aside * aside) - owner->getRadius());
    }
    void wallsStep(double, Enki::World* world) override {
        const double x = std::cos(owner->angle);
        const double y = std::sin(owner->angle);
        if (x != 0) wall_ = std::min(wall_, ((x > 0 ? world->w : 0) - owner->pos.x) / x - owner->getRadius());
        if (y != 0) wall_ = std::min(wall_, ((y > 0 ? world->h : 0) - owner->pos.y) / y - owner->getRadius());
    }

    [[nodiscard]] double robot() const { return robot_; }
    [[nodiscard]] double wall() const { return wall_; }

private:
    double robot_ = std::numeric_limits<double>::infinity();
    double wall_ = std::numeric_limits<double>::infinity();
};

class Body {
public:
    explicit Body(Enki::EPuck& puck, int number) : puck_(puck), eye_(&puck), number_(number) {
        puck_.addLocalInteraction(&eye_);
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

    [[nodiscard]] int number() const { return number_; }

    /// Returns whether a robot is in the line of sight, before any wall.
    [[nodiscard]] bool sees_robot() const { return eye_.robot() < eye_.wall(); }
    /// Returns the distance to the first object in the line of sight.
    [[nodiscard]] double distance() const { return std::max(0.0, std::min(eye_.robot(), eye_.wall())); }

    /// Sets the speeds of the wheels, cm/s.
    void wheels(double left, double right) {
        puck_.leftSpeed = left;
        puck_.rightSpeed = right;
    }
    /// Sets the forward speed, cm/s, and the turning speed, rad/s, counter-clockwise positive.
    void drive(double linear, double angular) {
        wheels(linear - angular * axle / 2, linear + angular * axle / 2);
    }

private:
    static constexpr double axle = 5.1;  // distance of the wheels of Enki's e-puck

    Enki::EPuck& puck_;
    Eye eye_;
    int number_;
};
