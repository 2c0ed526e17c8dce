S503 = { $count ->
    [one] další záznam na tomtéž řádku
    [few] { $count } další záznamy na tomtéž řádku
   *[other] { $count } dalších záznamů na tomtéž řádku
}
    .fix = dát každý záznam na vlastní řádek
    .fix-zero = `0` vynechat: sama je prázdný záznam
