"""Drives that never happened: plants, roads, drivers, actuators and sensors with a known truth."""
