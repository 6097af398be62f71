"""What images tell: how well at best, by Fisher's information, and what it is."""
