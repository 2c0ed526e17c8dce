W315 = tento komentář skrývá { $count ->
    [one] záznam: { $type } { $id }
    [few] { $count } záznamy, první je { $type } { $id }
   *[other] { $count } záznamů, první je { $type } { $id }
}
    .label = zde komentář začíná
    .first = toto by byl záznam
    .end = zde komentář končí
    .help = ukončete komentář znakem `#` na jeho řádku; nepotřebné záznamy raději odstraňte
    .fix = dát každý z obou řádků do vlastního komentáře
