"""A finished material → one archive that another lab unpacks and goes on from, without making again what is made."""
