"""The field of a lens: what varies over the sensor."""
